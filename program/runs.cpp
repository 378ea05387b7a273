#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/ensemble_options.hpp"
#include "program/found_runs.hpp"
#include "program/typed_scene.hpp"
#include "solver/run/run_identity.hpp"

namespace crawford {

namespace {

using Json = nlohmann::ordered_json;

Json amount(double value, const char* unit) {
    return {{"value", value}, {"unit", unit}};
}

Json json_of(const RunResults& results) {
    Json json = {{"regression_rate", amount(results.regression_rate, "m/s")},
                 {"mean_burn_rate", amount(results.mean_burn_rate, "m/s")},
                 {"largest_temperature", amount(results.largest_temperature, "K")}};
    if (results.strain_about_peak)
        json["strain_within_5_um_of_max"] = amount(*results.strain_about_peak, "1");
    if (results.steady) json["steady"] = *results.steady;
    return json;
}

Json json_of(const FoundRun& run) {
    Json json = {{"key", run.key},
                 {"scene", run.name},
                 {"title", run.scene ? run.scene->title : ""},
                 {"state", name_of(run.state)},
                 {"reason", run.reason},
                 {"time", amount(run.time, "s")},
                 {"end", run.scene ? amount(run.scene->time.end, "s") : Json()},
                 {"seeds", run.seeds},
                 {"results", run.results ? json_of(*run.results) : Json()},
                 {"directory", run.folder.string()},
                 {"solver_fingerprint", run.solver_fingerprint},
                 {"is_of_this_solver", run.solver_fingerprint == solver_fingerprint()}};
    return json;
}

std::string line_of(const FoundRun& run) {
    if (run.state == RunState::unreadable)
        return fmt::format("{:36}  {:10}  {}\n", "", name_of(run.state), run.reason);
    std::string line = fmt::format("{}  {:10}  t = {:.6g} of {:.6g} ms  ", run.key,
                                   name_of(run.state), 1e3 * run.time, 1e3 * run.scene->time.end);
    if (run.results)
        line += fmt::format("V = {:.5g} cm/s, max T = {:.5g} K  ",
                            100.0 * run.results->regression_rate, run.results->largest_temperature);
    line += fmt::format("{}  {}", run.name, run.folder.string());
    if (run.solver_fingerprint != solver_fingerprint()) line += "  (by another solver)";
    if (!run.reason.empty()) line += fmt::format("\n{:38}{}", "", run.reason);
    return line + '\n';
}

/// File names and reasons need not be UTF-8.
std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

int tell_key(const RunsOptions& options) {
    const std::string key = key_of(typed_scene(options.key, options.set));
    if (options.json)
        std::cout << text_of({{"key", key}, {"solver_fingerprint", solver_fingerprint()}});
    else
        std::cout << key << '\n';
    return exit_code::done;
}

}  // namespace

int runs(const RunsOptions& options) {
    if (options.list == !options.key.empty())
        throw InputError(
            "name one of --list and --key SCENE: what is there, or what a scene is known by");
    if (!options.key.empty()) return tell_key(options);
    const auto runs = found_runs(options.out);
    if (options.json) {
        Json list = Json::array();
        for (const FoundRun& run : runs) list.push_back(json_of(run));
        std::cout << text_of(list);
        return exit_code::done;
    }
    for (const FoundRun& run : runs) std::cout << line_of(run);
    std::cout << fmt::format("{} burns in {}, {} of them done\n", runs.size(), options.out.string(),
                             std::ranges::count(runs, RunState::done, &FoundRun::state));
    return exit_code::done;
}

}  // namespace crawford
