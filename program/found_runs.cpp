#include "program/found_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "program/burn_folder.hpp"
#include "solver/files/kept_manifest.hpp"
#include "solver/run/run_identity.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

std::string name_in(const fs::path& folder) {
    constexpr std::string_view ending = "_history.csv";
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        if (file.ends_with(ending)) names.push_back(file.substr(0, file.size() - ending.size()));
    }
    return names.empty() ? std::string() : *std::ranges::min_element(names);
}

/// Runs that are kept for figures are locked beside their folder (kept_runs.hpp).
bool is_under_way(const FoundRun& run) {
    return is_held(run.folder) || FileLock::is_held(run.folder.parent_path() / (run.key + ".lock"));
}

RunState state_of(const FoundRun& run, ManifestOutcome::Kind outcome) {
    if (is_under_way(run)) return RunState::running;
    switch (outcome) {
        case ManifestOutcome::Kind::done:
            return RunState::done;
        case ManifestOutcome::Kind::failed:
            return RunState::failed;
        default:
            return RunState::cut_off;
    }
}

void fill(FoundRun& run, const KeptManifest& manifest) {
    run.scene = parse_scene(manifest.scene);
    run.key = key_of(*run.scene);
    run.solver_fingerprint = manifest.solver_fingerprint;
    run.seeds = manifest.seeds;
    run.time = manifest.time;
    run.results = manifest.results;
    run.remarks = manifest.remarks;
    run.reason = manifest.outcome.reason;
    run.state = state_of(run, manifest.outcome.kind);
}

FoundRun run_in(const fs::path& folder) {
    FoundRun run;
    run.folder = folder;
    run.name = name_in(folder);
    return run;
}

FoundRun unreadable(const fs::path& folder, const std::string& why) {
    FoundRun run = run_in(folder);
    run.reason = why;
    return run;
}

FoundRun found(const fs::path& folder, const KeptManifest& manifest) {
    FoundRun run = run_in(folder);
    try {
        fill(run, manifest);
    } catch (const InputError& problem) {  // a scene that another version wrote
        return unreadable(folder, fmt::format("the scene in {}: {}",
                                              (folder / "manifest.json").string(), problem.what()));
    }
    return run;
}

/// Nothing if what lies there is no manifest of a burn.
std::optional<FoundRun> run_of(const fs::path& folder) {
    try {
        const auto manifest = kept_manifest(folder);
        return manifest ? std::optional(found(folder, *manifest)) : std::nullopt;
    } catch (const InputError& problem) {
        return unreadable(folder, problem.what());
    }
}

/// All below a folder, in the order of their names. What cannot be looked into may hold some: it is
/// not passed over.
std::vector<fs::path> manifests(const fs::path& below) {
    std::vector<fs::path> files;
    try {
        for (const auto& entry : fs::recursive_directory_iterator(below))
            if (entry.path().filename() == "manifest.json") files.push_back(entry.path());
    } catch (const fs::filesystem_error& problem) {  // does not always know where
        throw InputError(fmt::format("cannot look into all of {}: {}", below.string(),
                                     problem.code().message()));
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace

std::string name_of(RunState state) {
    switch (state) {
        case RunState::done:
            return "done";
        case RunState::running:
            return "running";
        case RunState::cut_off:
            return "cut off";
        case RunState::failed:
            return "failed";
        case RunState::unreadable:
            break;
    }
    return "unreadable";
}

std::vector<FoundRun> found_runs(const fs::path& below) {
    if (!fs::is_directory(below))
        throw InputError(fmt::format("{} is no folder; name one with burns", below.string()));
    std::vector<FoundRun> runs;
    for (const fs::path& file : manifests(below))
        if (auto run = run_of(file.parent_path())) runs.push_back(std::move(*run));
    return runs;
}

}  // namespace crawford
