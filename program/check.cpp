#include "program/check.hpp"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "program/commands.hpp"
#include "reports/wrapped.hpp"
#include "solver/files/guard_json.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/guards/steady_slab.hpp"
#include "solver/run/reduction.hpp"

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

/// "AP by itself burns 1.2 % faster", or hotter where the rate is prescribed.
std::string change(const std::string& material, const SteadySlab& with, const SteadySlab& without) {
    const double faster = 100.0 * (without.burn_rate / with.burn_rate - 1.0);
    const double hotter = without.surface_temperature - with.surface_temperature;
    if (faster == 0.0) return fmt::format(", {} by itself is {:+.2g} K hotter", material, hotter);
    return fmt::format(", {} by itself burns {:+.2g} % faster", material, faster);
}

std::string change_without_mechanics(const Scene& scene) {
    Scene rigid = scene;
    rigid.physics.mechanics = false;
    std::string changes;
    for (size_t k = 0; k < scene.morphology.materials.size(); ++k) {
        const SlabAnswer with = steady_slab(scene, k);
        const SlabAnswer without = steady_slab(rigid, k);
        if (with.burning == Burning::steady && without.burning == Burning::steady)
            changes += change(scene.morphology.materials[k].name, with.slab, without.slab);
    }
    return changes;
}

/// Keys that take something out of a run, each with what it costs.
std::vector<std::string> could_be_left_out(const Scene& scene) {
    const Physics& p = scene.physics;
    std::vector<std::string> keys;
    if (p.mechanics)
        keys.push_back(
            "physics.mechanics = false and physics.reference_map = false: stress and strain, nine "
            "tenths of a step" +
            change_without_mechanics(scene));
    if (p.reference_map && scene.morphology.indicator == Indicator::laboratory)
        keys.emplace_back("physics.reference_map = false: the strain, a hundredth of a step");
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
        {"left_out", reduced(scene).left_out},
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
        if (const std::string by_itself = reduced(scene).left_out; !by_itself.empty())
            std::cout << reports::wrapped("left out by itself: " + by_itself, "", width);
        for (const std::string& key : could_be_left_out(scene))
            std::cout << reports::wrapped("could be left out: " + key, "", width);
    }
    refuse(guards);
    return exit_code::done;
}

}  // namespace crawford
