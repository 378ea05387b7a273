#include "program/burn_json.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/failure.hpp"
#include "reports/failure_json.hpp"
#include "solver/files/guard_json.hpp"

namespace crawford {

namespace {

using Json = nlohmann::ordered_json;

std::string outcome_of(const BurnEnd& end) {
    if (end.failure)
        return failure_of(end.failure).exit_code == exit_code::wrong_input ? "refused" : "failed";
    return end.goes_on_with.empty() ? "done" : "interrupted";
}

Json json_of(const std::exception_ptr& problem) {
    Json json = {{"message", failure_of(problem).message}};
    try {
        std::rethrow_exception(problem);
    } catch (const NumericalFailure& failure) {
        json.update(Json(failure.fields()));
    } catch (...) {
        // All that is known of others is what they say.
    }
    return json;
}

void add_results(Json& json, const std::filesystem::path& out) {
    const Json manifest = Json::parse(std::ifstream(out / "manifest.json"), nullptr, false);
    for (const char* member : {"first_step", "last_step", "time_seconds", "results", "accuracy"})
        if (manifest.contains(member)) json[member] = manifest.at(member);
}

}  // namespace

std::string json_line(const BurnEnd& end) {
    Json json = {{"command", "burn"},
                 {"exit_code", end.failure ? failure_of(end.failure).exit_code : end.exit_code},
                 {"outcome", outcome_of(end)},
                 {"out", end.out.string()},
                 {"seconds", end.seconds},
                 {"remarks", Json::parse(remarks_to_json(end.remarks, {}))}};
    if (end.failure)
        json["failure"] = json_of(end.failure);
    else
        add_results(json, end.out);
    if (end.checkpoint) json["checkpoint"] = end.checkpoint->string();
    if (!end.goes_on_with.empty()) json["goes_on_with"] = end.goes_on_with;
    // The name of a directory need not be UTF-8.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace crawford
