#include "solver/files/kept_manifest.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>
#include <utility>

#include "base/errors.hpp"
#include "base/json_member.hpp"
#include "base/json_problem.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;
using Json = JsonMember::Json;

bool is_of_a_burn(const Json& json) {
    return json.is_object() && json.contains("scene") && json.contains("outcome") &&
           json.contains("program") && json.at("program") == "crawford";
}

ManifestOutcome outcome_of(const JsonMember& member) {
    const auto outcome = manifest_outcome(member.text());
    if (!outcome) member.refuse("is no outcome of a burn");
    return *outcome;
}

RunResults results_of(const JsonMember& json) {
    const auto value = [&](const char* name) { return json.at(name).at("value").number(); };
    RunResults results{.regression_rate = value("regression_rate"),
                       .mean_burn_rate = value("mean_burn_rate"),
                       .largest_temperature = value("largest_temperature")};
    if (json.has("strain_within_5_um_of_max"))
        results.strain_about_peak = value("strain_within_5_um_of_max");
    if (json.has("steady")) results.steady = json.at("steady").truth();
    return results;
}

std::map<std::string, std::string> remarks_of(const JsonMember& list) {
    std::map<std::string, std::string> remarks;
    for (const JsonMember& remark : list.items())
        remarks[remark.at("name").text()] = remark.at("text").text();
    return remarks;
}

long step_of(const JsonMember& member) {
    const unsigned long step = member.count();
    if (!std::in_range<long>(step)) member.refuse("is too large");
    return long(step);
}

KeptManifest manifest_of(const JsonMember& json) {
    KeptManifest manifest;
    manifest.outcome = outcome_of(json.at("outcome"));
    manifest.solver_fingerprint = json.at("solver_fingerprint").text();
    manifest.command = json.at("command").texts();
    manifest.scene = json.at("scene").text();
    manifest.last_step = step_of(json.at("last_step"));
    manifest.time = json.at("time_seconds").number();
    // Earlier versions have not written these, and none of these runs is any the worse.
    if (json.has("seeds"))
        for (const JsonMember& seed : json.at("seeds").items())
            manifest.seeds.push_back(seed.count());
    if (json.has("remarks")) manifest.remarks = remarks_of(json.at("remarks"));
    if (json.has("restarted_from")) manifest.restarted_from = json.at("restarted_from").text();
    if (json.has("results")) manifest.results = results_of(json.at("results"));
    return manifest;
}

}  // namespace

std::optional<KeptManifest> kept_manifest(const fs::path& folder) {
    const fs::path file = folder / "manifest.json";
    std::error_code unknown;
    if (!fs::exists(file, unknown)) return {};
    std::ifstream in(file);
    if (!in || fs::is_directory(file))
        throw InputError(fmt::format("{} cannot be read", file.string()));
    try {
        const Json json = Json::parse(in);
        if (!is_of_a_burn(json)) return {};
        return manifest_of(JsonMember(json));
    } catch (const Json::exception& problem) {
        throw InputError(
            fmt::format("{} is damaged: {}", file.string(), json_problem(problem.what())));
    } catch (const JsonRefused& problem) {
        throw InputError(fmt::format("{} is damaged: {}", file.string(), problem.what()));
    }
}

}  // namespace crawford
