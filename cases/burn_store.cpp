#include "cases/burn_store.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/scratch.hpp"
#include "cases/units.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/files/history.hpp"
#include "solver/run/burn.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

constexpr auto run_name = "burn";

fs::path place_of(const fs::path& out) {
    if (!out.empty()) return out / "burns";
    static const Scratch scratch;  // gone when the program ends
    return scratch.path();
}

/// "ap_binder_sandwich_64x96_20us_1a2b3c4d": to be read by people, told apart by the hash of the
/// whole scene.
fs::path directory_of(const Scene& scene, const fs::path& out) {
    const std::string text = to_toml(scene);
    boost::crc_32_type hash;
    hash.process_bytes(text.data(), text.size());
    std::string name;
    for (const char c : burn_title(scene)) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += char(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    return place_of(out) / fmt::format("{}_{:08x}", name, hash.checksum());
}

/// What the manifest of a directory says of its burn, if it is one of this scene by this solver.
std::optional<std::string> outcome_of(const fs::path& directory, const Scene& scene) {
    std::ifstream file(directory / "manifest.json");
    const auto manifest = nlohmann::json::parse(file, nullptr, false);
    if (!manifest.is_object()) return {};
    if (manifest.value("scene", "") != to_toml(scene) ||
        manifest.value("solver_fingerprint", "") != solver_fingerprint())
        return {};
    return manifest.value("outcome", "");
}

constexpr std::string_view failed = "failed: ";

bool has_ended(const std::optional<std::string>& outcome) {
    return outcome && (*outcome == "done" || outcome->starts_with(failed));
}

/// The last checkpoint before the end, if there is one.
std::optional<fs::path> last_checkpoint(const fs::path& directory, const Scene& scene) {
    for (long step = last_step(scene.time) - 1; step > 0; --step) {
        const fs::path file = checkpoint_file(directory, run_name, step);
        if (fs::exists(file)) return file;
    }
    return {};
}

void make(const Scene& scene, const fs::path& directory, const Request& request) {
    BurnOptions options{.name = run_name, .directory = directory};
    options.quiet = true;
    if (request.progress)
        options.progress = [&, what = burn_title(scene)](double done) {
            request.progress(what, done);
        };
    if (outcome_of(directory, scene)) {
        remove_halves(directory);
        options.restart = last_checkpoint(directory, scene);
    } else {
        fs::remove_all(directory);
    }
    burn(scene, options);
}

Snapshot snapshot_of(const Scene& scene, const fs::path& checkpoint) {
    Simulation simulation(scene);
    simulation.restore(load_checkpoint(checkpoint, to_toml(scene)).state);
    return collect_snapshot(simulation);
}

Burn load(const Scene& scene, const fs::path& directory) {
    Burn burn;
    burn.scene = scene;
    burn.directory = directory;
    for (const HistoryRow& row :
         read_history(directory / fmt::format("{}_history.csv", run_name))) {
        burn.time.push_back(row.time);
        burn.mean_burn_rate.push_back(row.mean_burn_rate);
        burn.largest_temperature.push_back(row.largest_temperature);
        burn.largest_strain.push_back(row.largest_strain);
        burn.strain_about_peak.push_back(row.strain_about_peak);
        burn.largest_pressure.push_back(row.largest_pressure);
        burn.pressure_about_peak.push_back(row.pressure_about_peak);
    }
    burn.last = burn.at(burn.time.back());
    return burn;
}

}  // namespace

Snapshot Burn::at(double wanted) const {
    const long step = std::lround(wanted / scene.time.step);
    const fs::path file = checkpoint_file(directory, run_name, step);
    if (!fs::exists(file))
        throw InputError(
            fmt::format("{} has no checkpoint at {:g} s; output.checkpoint_every = "
                        "{:g} s must divide it",
                        directory.string(), wanted, scene.output.checkpoint_every.value_or(0.0)));
    return snapshot_of(scene, file);
}

std::shared_ptr<const Burn> kept_burn(const Scene& scene, const Request& request) {
    const fs::path directory = directory_of(scene, request.out);
    prepare_directory(directory.parent_path());
    const FileLock lock(directory.string() + ".lock");
    if (!has_ended(outcome_of(directory, scene))) make(scene, directory, request);
    if (const auto outcome = outcome_of(directory, scene).value_or(""); outcome.starts_with(failed))
        throw NumericalFailure(outcome.substr(failed.size()));
    return std::make_shared<const Burn>(load(scene, directory));
}

bool is_kept(const Scene& scene, const fs::path& out) {
    return has_ended(outcome_of(directory_of(scene, out), scene));
}

double expected_seconds(const Scene& scene) {
    // Measured on one core: 65 ms a step with mechanics and 4.4 ms without on 128 x 96 cells.
    constexpr double with_mechanics = 5.3e-6, without = 0.36e-6;  // [s] a cell and step
    const double cells = double(scene.domain.nx) / (scene.domain.half ? 2 : 1) * scene.domain.ny;
    return cells * double(last_step(scene.time)) *
           (scene.physics.mechanics ? with_mechanics : without);
}

std::string burn_title(const Scene& scene) {
    return fmt::format("{}, {} x {}, {:g} us{}", scene.title, scene.domain.nx, scene.domain.ny,
                       scene.time.step / units::us, scene.physics.mechanics ? "" : ", rigid");
}

}  // namespace crawford
