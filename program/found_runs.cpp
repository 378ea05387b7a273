#include "program/found_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/whole_number.hpp"
#include "program/burn_folder.hpp"
#include "solver/run/run_identity.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view failed = "failed: ";
constexpr std::string_view cut_off = "cut off: ";

/// A manifest of a burn; figures have others, under other names.
bool is_of_a_burn(const Json& manifest) {
    return manifest.is_object() && manifest.contains("scene") && manifest.contains("outcome") &&
           manifest.value("program", "") == "crawford";
}

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

RunState state_of(const FoundRun& run, const std::string& outcome) {
    if (is_under_way(run)) return RunState::running;
    if (outcome == "done") return RunState::done;
    return outcome.starts_with(failed) ? RunState::failed : RunState::cut_off;
}

RunResults results_in(const Json& json) {
    const auto value = [&](const char* name) { return json.at(name).at("value").get<double>(); };
    RunResults results{.regression_rate = value("regression_rate"),
                       .mean_burn_rate = value("mean_burn_rate"),
                       .largest_temperature = value("largest_temperature")};
    if (json.contains("strain_within_5_um_of_max"))
        results.strain_about_peak = value("strain_within_5_um_of_max");
    if (json.contains("steady")) results.steady = json.at("steady").get<bool>();
    return results;
}

void fill(FoundRun& run, const Json& manifest) {
    run.scene = parse_scene(manifest.at("scene").get<std::string>());
    run.key = key_of(*run.scene);
    run.solver_fingerprint = manifest.value("solver_fingerprint", "");
    if (manifest.contains("seeds")) run.seeds = whole_numbers<std::uint64_t>(manifest.at("seeds"));
    run.time = manifest.value("time_seconds", 0.0);
    if (manifest.contains("results")) run.results = results_in(manifest.at("results"));
    for (const Json& remark : manifest.value("remarks", Json::array()))
        run.remarks[remark.at("name")] = remark.at("text");
    const auto outcome = manifest.at("outcome").get<std::string>();
    for (const std::string_view kind : {failed, cut_off})
        if (outcome.starts_with(kind)) run.reason = outcome.substr(kind.size());
    run.state = state_of(run, outcome);
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

FoundRun found(const fs::path& folder, const Json& manifest) {
    FoundRun run = run_in(folder);
    try {
        fill(run, manifest);
    } catch (const std::exception& problem) {  // a scene or JSON that another version wrote
        return unreadable(folder, problem.what());
    }
    return run;
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
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(below))
        if (entry.path().filename() == "manifest.json") files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<FoundRun> runs;
    for (const fs::path& file : files) {
        const auto manifest = Json::parse(std::ifstream(file), nullptr, false);
        if (manifest.is_discarded())
            runs.push_back(unreadable(file.parent_path(), "manifest.json is no JSON"));
        else if (is_of_a_burn(manifest))
            runs.push_back(found(file.parent_path(), manifest));
    }
    return runs;
}

}  // namespace crawford
