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

#include <cmath>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/evidence.hpp"
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

/// What the claims ask for.
namespace finds {
std::string surface(const std::string& name) {
    return name + ": surface temperature";
}
std::string error(const std::string& name) {
    return name + ": error of it";
}
std::string drop(const std::string& material, const std::string& reading) {
    return material + ": colder with c_p, as the paper, " + reading;
}
constexpr auto three_alpha = "3 alpha K", alpha = "alpha K";
/// The run with mechanics as read.
std::string coupled(const std::string& material) {
    return material + "_three_alpha";
}
}  // namespace finds

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
    outcome.findings.push_back({finds::surface(name), run.temperature.back(), "K"});
    outcome.findings.push_back(
        {finds::error(name), run.temperature.back() - exact.surface_temperature(), "K"});
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
    const double three = add(outcome, finds::coupled(material), burning, SlabModel::eulerian);
    const double one = add(outcome, material + "_alpha", Slab(burning).thermal_stress_alpha_k(),
                           SlabModel::eulerian);
    outcome.findings.push_back({finds::drop(material, finds::three_alpha), rigid - three, "K"});
    outcome.findings.push_back({finds::drop(material, finds::alpha), rigid - one, "K"});
}

Outcome fig04(const Request& request) {
    Outcome outcome{reports::Figure("fig04", request.out), {}, {}};
    add_material(outcome, "AP", 200.0 * cal / (s * cm2), request.fidelity);
    add_material(outcome, "binder", 100.0 * cal / (s * cm2), request.fidelity);
    outcome.figure.caption({.grid = fmt::format("1 × {}, clustering 2", cells(request.fidelity)),
                            .step = "steady",
                            .revision = revision(),
                            .note = "points: solver, lines: exact"});
    outcome.figure.panel("a").panel("b");
    return outcome;
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    using namespace reports;
    const auto found = evidence.findings_of("fig04");
    const auto drop = [&](const std::string& material, const std::string& reading) {
        return found(finds::drop(material, reading));
    };
    const double rise = found(finds::surface(finds::coupled("AP"))) - 300.0;
    const double ap = drop("AP", finds::three_alpha);
    const double error = std::abs(found(finds::error(finds::coupled("binder"))));
    return {
        judged(Statement{
            "drop of the surface temperature of AP", "Fig. 4a", "fig04", "almost negligible",
            fmt::format("{:.2g} K (3 alpha K), {:.2g} K (alpha K)", ap, drop("AP", finds::alpha)),
            "q_s = 0", ap < 0.01 * rise, "Below 1 % of the rise under both readings of beta."}),
        judged({"drop of the surface temperature of binder", "Fig. 4b", "fig04", "K", "about 80",
                80.0, 5.0 + 8.0},
               {drop("binder", finds::three_alpha),
                {.grid = error, .step = 0.0},
                "3 alpha K, q_s = 0",
                {{"alpha K", drop("binder", finds::alpha)}},
                "Eqs. 50-53 are written with alpha K, eq. 38 with 3 alpha K; in Kuznetsov "
                "and Stewart's small strain it is 47.5 K with alpha K.",
                "{:.1f}"})};
}

const Registered here{{.name = "fig04",
                       .figure = "Fig. 4",
                       .shows = "slabs: surface with and without mechanics",
                       .physics = {physics::heat, physics::coupling, physics::slab},
                       .cost = {.draft = 3.0, .paper = 8.0},
                       .draw = fig04,
                       .claims = claims}};

}  // namespace

}  // namespace crawford
