#include "program/left_off.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "program/burn_folder.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/files/history.hpp"
#include "solver/run/run_identity.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

/// A run that was asked for less output is not taken for one that has it all.
bool serves(const KeptManifest& manifest, const Scene& scene) {
    if (manifest.solver_fingerprint != solver_fingerprint()) return false;
    const Scene kept = parse_scene(manifest.scene);
    return identity_of(kept) == identity_of(scene) &&
           covers(kept.output, scene.output, scene.time.step);
}

std::optional<long> step_of(const fs::path& checkpoint, const std::string& name) {
    const std::string file = checkpoint.filename().string();
    const std::string start = name + "_checkpoint_";
    if (!file.starts_with(start) || !file.ends_with(".h5")) return {};
    long step = 0;
    const auto [end, error] =
        std::from_chars(file.data() + start.size(), file.data() + file.size(), step);
    if (error != std::errc() || std::string_view(end) != ".h5") return {};
    return step;
}

/// Those of the name, the last first.
std::vector<fs::path> checkpoints(const fs::path& folder, const std::string& name) {
    std::vector<std::pair<long, fs::path>> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (const auto step = step_of(entry.path(), name)) found.emplace_back(*step, entry.path());
    std::ranges::sort(found, std::greater());
    std::vector<fs::path> files;
    for (const auto& [step, file] : found) files.push_back(file);
    return files;
}

/// The time of a checkpoint [s]; nothing if it is damaged or of another scene.
std::optional<double> time_of(const fs::path& file, const std::vector<std::string>& scenes) {
    for (const std::string& scene : scenes) {
        try {
            return load_checkpoint(file, scene).state.time;
        } catch (const InputError&) {
            // It may be of another of them; and where it is damaged, the one before may be sound.
        }
    }
    return {};
}

/// The time of the last row [s]; 0 where there is none.
double time_of_history(const fs::path& folder, const std::string& name) {
    try {
        const auto rows = read_history(folder / (name + "_history.csv"));
        return rows.empty() ? 0.0 : rows.back().time;
    } catch (const InputError&) {
        return 0.0;
    }
}

}  // namespace

LeftOff left_off(const fs::path& folder, const std::string& name, const Scene& scene,
                 const std::vector<std::string>& computed) {
    using Outcome = ManifestOutcome::Kind;
    const auto manifest = manifest_there(folder);
    if (!manifest || !serves(*manifest, scene)) return {};
    if (manifest->outcome.kind == Outcome::done) return {.is_done = true, .checkpoint = {}};
    const bool was_interrupted =
        manifest->outcome.kind == Outcome::interrupted;      // and so was before its end
    const fs::path gone_on_from = manifest->restarted_from;  // likewise
    const double last_row = time_of_history(folder, name);
    for (const fs::path& file : checkpoints(folder, name)) {
        const auto time = time_of(file, computed);
        if (!time) continue;
        if (was_interrupted || file.filename() == gone_on_from.filename() || *time < last_row)
            return {.is_done = false, .checkpoint = file};
    }
    return {};
}

}  // namespace crawford
