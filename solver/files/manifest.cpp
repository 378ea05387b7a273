#include "solver/files/manifest.hpp"

#include <fmt/chrono.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "base/peak_memory.hpp"
#include "solver/files/guard_json.hpp"
#include "solver/files/machine.hpp"

namespace crawford {

namespace {

std::string time_of_day(std::chrono::system_clock::time_point time) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

nlohmann::ordered_json amount(double value, const char* unit) {
    return {{"value", value}, {"unit", unit}};
}

nlohmann::ordered_json json_of(const RunResults& results, double time) {
    nlohmann::ordered_json json = {
        {"regression_rate", amount(results.regression_rate, "m/s")},
        {"mean_burn_rate", amount(results.mean_burn_rate, "m/s")},
        {"largest_temperature", amount(results.largest_temperature, "K")}};
    if (results.strain_about_peak)
        json["strain_within_5_um_of_max"] = amount(*results.strain_about_peak, "1");
    if (results.steady) json["steady"] = *results.steady;
    if (results.steady.value_or(false)) json["steady_at"] = amount(time, "s");
    return json;
}

}  // namespace

void write_manifest(const std::filesystem::path& path, const Manifest& manifest) {
    nlohmann::ordered_json json = {
        {"program", "crawford"},
        {"version", version()},
        {"revision", revision()},
        {"solver_fingerprint", solver_fingerprint()},
        {"compiler", compiler()},
        {"flags", flags()},
        {"libraries", nlohmann::ordered_json::parse(libraries())},
        {"machine", nlohmann::ordered_json::parse(machine())},
        {"command", manifest.command},
        {"outcome", text_of(manifest.outcome)},
        {"started", time_of_day(manifest.started)},
        {"ended", time_of_day(manifest.ended)},
        {"wall_seconds", manifest.wall_seconds},
        {"peak_memory_bytes", peak_memory()},
        {"first_step", manifest.first_step},
        {"last_step", manifest.last_step},
        {"time_seconds", manifest.time},
        {"seeds", manifest.seeds},
        {"scene", manifest.scene},
        {"left_out", manifest.left_out},
        {"predicted", nlohmann::ordered_json::parse(to_json(manifest.predicted))},
        {"met", nlohmann::ordered_json::parse(to_json(manifest.met))},
        {"remarks",
         nlohmann::ordered_json::parse(remarks_to_json(manifest.predicted, manifest.met))},
    };
    if (manifest.steps)
        json["steps"] = {{"shortest_seconds", manifest.steps->shortest},
                         {"longest_seconds", manifest.steps->longest},
                         {"rejected", manifest.steps->rejected},
                         {"failed_and_tried_again", manifest.steps->failed}};
    if (manifest.restarted_from) json["restarted_from"] = *manifest.restarted_from;
    if (manifest.results) json["results"] = json_of(*manifest.results, manifest.time);
    // A file name need not be UTF-8; a manifest with a replaced character is better than none.
    write_file(path,
               json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace crawford
