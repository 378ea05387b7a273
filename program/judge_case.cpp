#include "program/judge_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "program/told_truth.hpp"
#include "reports/wrapped.hpp"

namespace crawford {

namespace {

using reports::expect;
using reports::Norm;

JudgeCase slab() {
    const auto order = expect(2.0).within(0.1);
    const auto stress = expect(2.0).or_better(0.1).scattering(0.4);
    return {
        .name = "slab",
        .truth = "slab",
        .task =
            "A slab of AP regresses steadily at burn_rate under heat_flux Q and pressure p_c, "
            "plane strain, no motion in x. In the frame of its surface, y = 0, up to which it "
            "streams at r_b + v: rho c_p (r_b + v) dT/dy = d/dy(kappa dT/dy) - beta T dv/dy; "
            "d sigma_yy/dy = 0 with sigma_yy = -p_c. At the surface Q enters and q_s rho r_b is "
            "taken; far below T = cold_temperature. Any depth that the heat does not reach.",
        .set = {},
        .gates = {{"temperature", Norm::L2, order, "second order in space; the profile is smooth"},
                  {"temperature", Norm::Linf, order, "the same at the worst point"},
                  {"velocity_y", Norm::L2, order, "v follows T"},
                  {"stress_xx", Norm::L2, stress, "2, or more while advection leads"}},
        .bounds = {}};
}

JudgeCase sandwich_thermal() {
    return {
        .name = "sandwich-thermal",
        .truth = "thermal-sandwich",
        .task =
            "A rigid sandwich with a flat surface, y = 0, burns steadily at burn_rate: a strip of "
            "binder about x = 0 between AP, period `width` in x, bottom at y = -depth with T = "
            "cold_temperature. rho c_p r_b dT/dy = div(kappa grad T); at the surface kappa dT/dy "
            "= Q + q_s rho r_b with the Q, q_s and rho of the material below. T and the heat "
            "flux are continuous across the interfaces.",
        .set = {},
        .gates = {},
        .bounds = {{"temperature", 0.3,
                    "as the study of this name: 0.05 % of the rise; T behaves as r ln r where "
                    "the interface meets the surface, so no order is asked for"}}};
}

JudgeCase sandwich_mechanical() {
    return {
        .name = "sandwich-mechanical",
        .truth = "elastic-sandwich",
        .task =
            "A cold sandwich at rest, plane strain, linear elasticity: a strip of binder about x "
            "= 0 between AP, period `width` in x, clamped at y = -depth (u = v = 0), pressed by "
            "`pressure` on its flat surface y = 0. Displacement and traction are continuous "
            "across the interfaces. Stress grows as r^-0.405 where they meet the surface, so "
            "no order is asked for: give --expect.",
        .set = {"support=clamped"},
        .gates = {},
        .bounds = {}};
}

const std::vector<JudgeCase>& own_cases() {
    static const std::vector<JudgeCase> all{slab(), sandwich_thermal(), sandwich_mechanical()};
    return all;
}

std::string gates_text(const JudgeCase& one) {
    std::string text = "\nGates (--expect P --within D sets others):\n";
    for (const auto& gate : one.gates)
        text +=
            reports::wrapped(fmt::format("{}, {}: order {:g} - {:g}{} ({})", gate.quantity,
                                         name(gate.norm), gate.expected.order, gate.expected.below,
                                         std::isinf(gate.expected.above)
                                             ? ", or better"
                                             : fmt::format(" + {:g}", gate.expected.above),
                                         gate.reason),
                             "  ", 100);
    for (const auto& bound : one.bounds)
        text +=
            reports::wrapped(fmt::format("{}: largest error on the finest grid at most {:g} ({})",
                                         bound.field, bound.most, bound.reason),
                             "  ", 100);
    if (one.gates.empty() && one.bounds.empty()) text += "  none: give --expect\n";
    return text;
}

}  // namespace

JudgeCase judge_case(const std::string& name) {
    const auto own = std::ranges::find(own_cases(), name, &JudgeCase::name);
    if (own != own_cases().end()) return *own;
    std::vector<std::string> names;
    for (const JudgeCase& one : own_cases()) names.push_back(one.name);
    for (const auto& entry : reference::truths()) {
        if (entry.name == name)
            return {.name = name,
                    .truth = name,
                    .task = entry.description,
                    .set = {},
                    .gates = {},
                    .bounds = {}};
        names.push_back(entry.name);
    }
    throw InputError(fmt::format("no case is called {}{}", name, suggestion(name, names)));
}

std::string described(const JudgeCase& one) {
    auto text =
        fmt::format("{}: what to solve\n{}", one.name, reports::wrapped(one.task, "  ", 100));
    for (const auto& set : one.set) text += fmt::format("  with {}\n", set);
    return text + gates_text(one) + "\nIts exact solution is the truth " + described(one.entry());
}

std::string described_as_json(const JudgeCase& one) {
    using Json = nlohmann::ordered_json;
    const auto& entry = one.entry();
    Json parameters = Json::array(), fields = Json::array(), gates = Json::array(),
         bounds = Json::array(), points = Json::array();
    for (const auto& p : entry.parameters)
        parameters.push_back({{"name", p.name},
                              {"unit", p.unit},
                              {"standard", standard_of(p)},
                              {"limits", limits_of(p)},
                              {"meaning", p.meaning}});
    for (const auto& f : entry.fields)
        fields.push_back({{"name", f.name}, {"unit", f.unit}, {"meaning", f.meaning}});
    for (const auto& g : one.gates)
        gates.push_back({{"field", g.quantity},
                         {"norm", name(g.norm)},
                         {"order", g.expected.order},
                         {"below", g.expected.below},
                         {"above", g.expected.above},
                         {"reason", g.reason}});
    for (const auto& b : one.bounds)
        bounds.push_back({{"field", b.field}, {"most", b.most}, {"reason", b.reason}});
    for (const auto& p : entry.examples) points.push_back({p.x(), p.y()});
    const Json json{{"case", one.name},        {"truth", one.truth}, {"task", one.task},
                    {"source", entry.source},  {"set", one.set},     {"parameters", parameters},
                    {"fields", fields},        {"gates", gates},     {"bounds", bounds},
                    {"example_points", points}};
    return json.dump(2) + '\n';
}

}  // namespace crawford
