/// # Figure 4: how much does mechanics cool the surface?
///
/// The same slab burns twice, as a rigid conductor and with thermal stress: AP under 200 cal/(s
/// cm2), binder under 100. Expansion against its own stiffness takes heat, -beta T div v, and the
/// surface ends up colder: AP by a few kelvin, the binder by hundreds with beta = 3 alpha K and by
/// about 74 K with beta = alpha K, the reading that gives the paper's "about 80 K". Each profile
/// stands on an exact solution, drawn as a line; the points are the solver's.
///
/// What is model here: the reading of beta, and that rho stays constant while the solid expands.
/// The solver's own error is below 0.1 K.

#include <fmt/format.h>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/units.hpp"
#include "reference/slab.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::SlabModel;

int cells(Fidelity fidelity) {
    return fidelity == Fidelity::draft ? 48 : fidelity == Fidelity::paper ? 96 : 192;
}

std::vector<double> temperatures(const reference::Slab& exact, const std::vector<double>& y) {
    std::vector<double> values;
    for (const auto& state : exact.states(y)) values.push_back(state.temperature);
    return values;
}

/// Adds the solver's and the exact temperature of one slab to the figure.
/// \returns the solver's surface temperature [K]
double add(Outcome& outcome, const std::string& name, const Slab& slab, SlabModel model) {
    const Scene scene = slab.scene();
    const SlabProfile run = burn_to_steady(scene);
    const reference::Slab exact(slab.conditions(model));
    std::vector<double> line;  // every 0.5 um, so that no corner shows between nodes
    for (int k = 0; k <= 200; ++k) line.push_back(-0.5 * um * k);
    outcome.figure
        .table(name, {{"depth", "um", scaled(run.node_y, -um)},
                      {"T", "K", run.temperature},
                      {"exact T", "K", temperatures(exact, run.node_y)}})
        .table("exact_" + name,
               {{"depth", "um", scaled(line, -um)}, {"T", "K", temperatures(exact, line)}});
    outcome.scenes.push_back(scene);
    outcome.findings.push_back({name + ": surface temperature", run.temperature.back(), "K"});
    outcome.findings.push_back(
        {name + ": error of it", run.temperature.back() - exact.surface_temperature(), "K"});
    return run.temperature.back();
}

void add_material(Outcome& outcome, const std::string& material, double flux, Fidelity fidelity) {
    const Slab burning = slab(material, {.cells = cells(fidelity), .clustering = 2.0})
                             .regressing(0.45 * cm / s)
                             .heated(flux)
                             .pressed(2.0 * MPa);
    outcome.figure.set("flux_" + material, flux / (cal / (s * cm2)));
    const double rigid =
        add(outcome, material + "_thermal", Slab(burning).rigid(), SlabModel::thermal);
    const double three = add(outcome, material + "_three_alpha", burning, SlabModel::eulerian);
    const double one = add(outcome, material + "_alpha", Slab(burning).thermal_stress_alpha_k(),
                           SlabModel::eulerian);
    outcome.findings.push_back({material + ": colder by mechanics, 3 alpha K", rigid - three, "K"});
    outcome.findings.push_back({material + ": colder by mechanics, alpha K", rigid - one, "K"});
}

Outcome fig04(const Request& request) {
    Outcome outcome{reports::Figure("fig04", request.out, "cases/paper/fig04.gp"), {}, {}};
    add_material(outcome, "AP", 200.0 * cal / (s * cm2), request.fidelity);
    add_material(outcome, "binder", 100.0 * cal / (s * cm2), request.fidelity);
    outcome.figure.caption({.grid = fmt::format("1 × {}, clustering 2", cells(request.fidelity)),
                            .step = "steady",
                            .revision = revision(),
                            .note = "points: solver, lines: exact"});
    outcome.figure.panel("a").panel("b");
    return outcome;
}

const Registered here{{.name = "fig04",
                       .figure = "Fig. 4",
                       .shows = "slabs: surface with and without mechanics",
                       .physics = {physics::heat, physics::coupling, physics::slab},
                       .cost = {.draft = 3.0, .paper = 8.0},
                       .draw = fig04}};

}  // namespace

}  // namespace crawford
