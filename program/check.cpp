#include "program/check.hpp"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <variant>

#include "program/commands.hpp"
#include "reports/wrapped.hpp"
#include "solver/files/guard_json.hpp"
#include "solver/guards/predicted.hpp"

namespace crawford {

namespace {

constexpr size_t width = 80;
constexpr auto indent = "    ";

std::string verdict(const Guard& guard) {
    switch (guard.beyond) {
        case Beyond::nothing:
            return guard.limit ? "within" : "";
        case Beyond::remark:
            return "remark:";
        case Beyond::refusal:
            return "refused:";
    }
    return "";
}

void print(const Guards& guards) {
    for (const Guard& guard : guards) {
        const std::string limit = guard.limit ? fmt::format("{:.4g}", *guard.limit) : "-";
        std::cout << fmt::format("{:<18} {:>10.4g}  limit {:>7}  {}\n", guard.name, guard.value,
                                 limit, verdict(guard));
        if (!guard.text.empty()) std::cout << reports::wrapped(guard.text, indent, width);
    }
}

/// Keys that take something out of a run, each with what it costs.
std::vector<std::string> could_be_left_out(const Scene& scene) {
    const Physics& p = scene.physics;
    std::vector<std::string> keys;
    if (p.mechanics)
        keys.emplace_back(
            "physics.mechanics = false and physics.reference_map = false: stress and strain, nine "
            "tenths of a step; the burn rate "
            "changes by what expansion takes of the heat");
    if (p.reference_map && scene.morphology.indicator == Indicator::laboratory)
        keys.emplace_back("physics.reference_map = false: the strain, a hundredth of a step");
    if (scene.domain.nx > 1 && std::holds_alternative<Uniform>(scene.morphology.shape))
        keys.emplace_back("domain.nx = 1: columns that are all alike");
    if (!scene.domain.half && std::holds_alternative<Sandwich>(scene.morphology.shape))
        keys.emplace_back("domain.half = true: the other half of a sandwich, which is the same");
    return keys;
}

nlohmann::ordered_json refused(const Guards& guards) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Guard& guard : guards)
        if (guard.beyond == Beyond::refusal)
            list.push_back({{"name", guard.name}, {"text", guard.text}});
    return list;
}

void print_json(const Guards& guards, const Scene& scene) {
    const nlohmann::ordered_json json = {
        {"predicted", nlohmann::ordered_json::parse(to_json(guards))},
        {"remarks", nlohmann::ordered_json::parse(remarks_to_json(guards, {}))},
        {"refused", refused(guards)},
        {"could_be_left_out", could_be_left_out(scene)}};
    std::cout << json.dump(2) << '\n';
}

}  // namespace

int check(const Scene& scene, bool json) {
    const Guards guards = predicted(scene);
    if (json) {
        print_json(guards, scene);
    } else {
        print(guards);
        for (const std::string& key : could_be_left_out(scene))
            std::cout << reports::wrapped("could be left out: " + key, "", width);
    }
    refuse(guards);
    return exit_code::done;
}

}  // namespace crawford
