/// # Figure 11: the shape of the burning surface
///
/// The surface of the sandwich of figure 7 once it moves without changing its shape, with and
/// without mechanics, each with its first grid point moved to the origin. The binder burns at
/// another temperature than AP and the surface finds the shape in which both recede equally fast.
///
/// The profile follows from the burn rate alone (phi_t = -r_b sqrt(1 + phi_x^2)), not from the
/// motion of the material: the surface of the thermo-mechanical run bulges outwards only as far as
/// its burn rate lets it. The displacement of the material itself is the distance to its reference
/// position; its largest outward value is given beside the figure.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/scenes/sandwich_measures.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

SurfaceLine from_origin(SurfaceLine line) {
    const double x = line.x.front();
    const double height = line.height.front();
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        line.x[i] -= x;
        line.height[i] -= height;
    }
    return line;
}

/// What the claims ask for.
namespace finds {
constexpr auto displacement = "largest outward displacement of the material";
std::string highest(const std::string& run) {
    return run + ": highest point above the edge";
}
}  // namespace finds

constexpr auto with_mechanics = "coupled";

void add(Outcome& outcome, const std::string& name, const Burn& burn) {
    const SurfaceLine line = from_origin(surface_line(burn.last));
    const auto [lowest, highest] = std::ranges::minmax(line.height);
    outcome.figure.table(
        name, {{"x", "um", scaled(line.x, um)}, {"height", "um", scaled(line.height, um)}});
    outcome.findings.push_back({finds::highest(name), highest / um, "um"});
    outcome.findings.push_back({name + ": lowest point above the edge", lowest / um, "um"});
    outcome.scenes.push_back(burn.scene);
}

Outcome fig11(const Request& request) {
    const auto thermal = kept_burn(burning_sandwich(request.fidelity, false), request);
    const auto coupled = kept_burn(burning_sandwich(request.fidelity, true), request);
    Outcome outcome{reports::Figure("fig11", request.out), {}, {}};
    add(outcome, "thermal", *thermal);
    add(outcome, with_mechanics, *coupled);
    outcome.findings.push_back(
        {finds::displacement, largest_outward_displacement(coupled->last) / um, "um"});
    outcome.figure.caption({.grid = grid_text(coupled->scene),
                            .step = step_text(coupled->scene),
                            .revision = revision()});
    return outcome;
}

/// Of x and y together, and of dt.
reports::Uncertainty uncertainty(const ledger::Evidence& evidence, const ledger::Measure& measure) {
    const auto of = [&](const char* direction) {
        return ledger::index(evidence, "burning sandwich", measure, direction);
    };
    const auto x = of("x"), y = of("y");
    return {.grid = x && y ? std::optional(std::hypot(*x, *y)) : std::nullopt, .step = of("dt")};
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    const auto found = evidence.findings_of("fig11");
    return {reports::judged(
        {"largest outward displacement, binder", "Fig. 11", "fig11", "um", "roughly 8", 8.0,
         0.5 + 0.8},
        {found(finds::highest(with_mechanics)), uncertainty(evidence, ledger::height_of_profile),
         "3 alpha K, c_p, strip of 60 um; height above the first point, as drawn",
         ledger::others(evidence.sandwich_readings, ledger::quantity::height_of_profile),
         fmt::format(
             "The material itself has moved out by {:.1f} um. {}", found(finds::displacement),
             ledger::divergence(evidence, "burning sandwich", ledger::height_of_profile, "x")),
         "{:.1f}"})};
}

const Registered here{
    {.name = "fig11",
     .figure = "Fig. 11",
     .shows = "sandwich: steady profile of the surface",
     .physics = {physics::burning, physics::coupling, physics::sandwich},
     .cost = {.draft = 8.0, .paper = 80.0},
     .draw = fig11,
     .burns =
         [](Fidelity f) {
             return std::vector{burning_sandwich(f, false), burning_sandwich(f, true)};
         },
     .claims = claims,
     .claims_rest_on = LedgerRuns::sandwich}};

}  // namespace

}  // namespace crawford
