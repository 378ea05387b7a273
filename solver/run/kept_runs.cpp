#include "solver/run/kept_runs.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/files/history.hpp"
#include "solver/files/kept_manifest.hpp"
#include "solver/run/burn.hpp"
#include "solver/run/loop.hpp"
#include "solver/run/run_identity.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

constexpr auto run_name = "burn";

/// What lies in a directory of the store.
struct Found {
    ManifestOutcome::Kind outcome;
    Output output;

    /// One that failed has not: it is tried again from its last checkpoint.
    bool has_ended() const { return outcome == ManifestOutcome::Kind::done; }
    bool serves(const Scene& scene) const {
        return has_ended() && covers(output, scene.output, scene.time.step);
    }
};

/// Whether the history has the last row, and all before it, of a run that has reached `last_step`.
bool is_whole(const fs::path& history, const Scene& scene, long last_step) {
    const auto rows = read_history(history);
    const long every = scene.output.history_every;
    if (long(rows.size()) < last_step / every) return false;
    return !rows.empty() &&
           std::lround(rows.back().time / scene.time.step) >= last_step - last_step % every;
}

/// Nothing if it is no run of this scene by this solver, or cannot be understood.
std::optional<Found> find(const fs::path& directory, const Scene& scene) {
    try {
        const auto manifest = kept_manifest(directory);
        if (!manifest || manifest->solver_fingerprint != solver_fingerprint()) return {};
        const Scene kept = parse_scene(manifest->scene);
        if (identity_of(kept) != identity_of(scene)) return {};
        const Found found{manifest->outcome.kind, kept.output};
        const fs::path history = directory / fmt::format("{}_history.csv", run_name);
        if (found.has_ended() && !is_whole(history, kept, manifest->last_step)) return {};
        return found;
    } catch (const InputError&) {
        return {};
    }
}

bool can_be_read(const fs::path& checkpoint, const Scene& scene) {
    try {
        load_checkpoint(checkpoint, to_toml(scene));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

/// The last sound checkpoint before the end, if there is one.
std::optional<fs::path> last_checkpoint(const fs::path& directory, const Scene& scene) {
    for (long step = last_step(scene.time) - 1; step > 0; --step) {
        const fs::path file = checkpoint_file(directory, run_name, step);
        if (fs::exists(file) && can_be_read(file, scene)) return file;
    }
    return {};
}

void make(Scene scene, const std::optional<Found>& found, const fs::path& directory,
          const std::function<void(double)>& progress) {
    if (scene.time.accuracy)
        throw InputError(
            "time.step = \"auto\" is for crawford burn: runs that are kept for figures "
            "are known by the number of their steps; give a time.step");
    BurnOptions options{.name = run_name, .directory = directory};
    if (progress)
        options.watch = [&](const BurnProgress& p) {
            progress(double(p.now.step) / double(p.last_step));
        };
    const bool goes_on =
        found && !found->has_ended() && covers(found->output, scene.output, scene.time.step);
    if (found) scene.output = united(found->output, scene.output, scene.time.step);
    if (goes_on) {
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

KeptRun load(const Scene& scene, const fs::path& directory) {
    KeptRun run;
    run.scene = scene;
    run.directory = directory;
    for (const HistoryRow& row :
         read_history(directory / fmt::format("{}_history.csv", run_name))) {
        run.time.push_back(row.time);
        run.mean_burn_rate.push_back(row.mean_burn_rate);
        run.regression_rate.push_back(row.regression_rate);
        run.largest_temperature.push_back(row.largest_temperature);
        run.largest_strain.push_back(row.largest_strain);
        run.strain_about_peak.push_back(row.strain_about_peak);
        run.largest_pressure.push_back(row.largest_pressure);
        run.pressure_about_peak.push_back(row.pressure_about_peak);
    }
    run.last = run.at(run.time.back());
    return run;
}

}  // namespace

Snapshot KeptRun::at(double wanted) const {
    const long step = std::lround(wanted / scene.time.step);
    const fs::path file = checkpoint_file(directory, run_name, step);
    if (!fs::exists(file))
        throw InputError(
            fmt::format("{} has no checkpoint at {:g} s; output.checkpoint_every = "
                        "{:g} s must divide it",
                        directory.string(), wanted, scene.output.checkpoint_every.value_or(0.0)));
    return snapshot_of(scene, file);
}

/// "ap_binder_sandwich_64x96_20us_<key>": to be read by people, told apart by the key.
fs::path KeptRuns::directory_of(const Scene& scene) const {
    std::string name;
    for (const char c : run_title(scene)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += char(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    const std::string known_by = key_of(scene);
    // A title is no part of the identity: a run that lies there under another one is taken.
    if (fs::exists(place_))
        for (const auto& entry : fs::directory_iterator(place_))
            if (entry.is_directory() && entry.path().filename().string().ends_with(known_by))
                return entry.path();
    return place_ / fmt::format("{}_{}", name, known_by);
}

std::shared_ptr<const KeptRun> KeptRuns::get(const Scene& scene,
                                             const std::function<void(double)>& progress) const {
    prepare_directory(place_);
    const FileLock lock(place_ / (key_of(scene) + ".lock"));
    const fs::path directory = directory_of(scene);
    const auto found = find(directory, scene);
    if (!found || !found->serves(scene)) make(scene, found, directory, progress);
    return std::make_shared<const KeptRun>(load(scene, directory));
}

bool KeptRuns::has(const Scene& scene) const {
    const auto found = find(directory_of(scene), scene);
    return found && found->serves(scene);
}

}  // namespace crawford
