/// # Slab: how exact is the solver where the exact solution is known?
///
/// A homogeneous slab that regresses steadily at 0.45 cm/s has a closed-form solution
/// (reference/slab.hpp) of the very equations the solver discretises: constant density, convection
/// with r_b + v, stress work -beta T div v. The truth shares no line of code with the solver, nor
/// its table of materials, and a second, independent integration by shooting agrees with it to
/// 1e-10. It is taken at the same finite depth: at 480 um the bottom, held at 300 K, changes the
/// binder's temperature by 1e-4, as much as the grid error on 256 cells.
///
/// The steady state does not depend on the time step, so what is left is the error in space.
/// Kuznetsov and Stewart's small-strain solution is another model, not another truth: the distance
/// to it does not fall with the grid and is shown as such.

#include "cases/catalogue/slab.hpp"

#include <fmt/format.h>

#include "cases/catalogue/registry.hpp"
#include "cases/catalogue/units.hpp"
#include "reference/slab.hpp"

namespace crawford {

namespace {

using reference::SlabModel;
using reports::expect;
using reports::Measurement;
using reports::Norm;

Slab burning(const std::string& material, int cells) {
    using namespace units;
    const double flux = material == "AP" ? 200.0 : 100.0;
    return slab(material, {.cells = cells})
        .regressing(0.45 * cm / s)
        .heated(flux * cal / (s * cm2))
        .pressed(2.0 * MPa);
}

using Component = double reference::SlabState::*;

std::vector<double> column(const std::vector<reference::SlabState>& states, Component component) {
    std::vector<double> values;
    for (const auto& state : states) values.push_back(state.*component);
    return values;
}

Measurement measure(const Slab& slab, int cells) {
    using State = reference::SlabState;
    const SlabProfile run = burn_to_steady(slab.scene());
    const reference::Slab exact(slab.conditions(SlabModel::eulerian));
    const reference::Slab small_strain(slab.conditions(SlabModel::kuznetsov_stewart));
    const auto nodes = exact.states(run.node_y);
    const auto centres = exact.states(run.cell_y);
    const double surface = run.temperature.back();

    Measurement result(1.0 / cells);
    result.field("T", run.temperature, column(nodes, &State::temperature), run.node_weight)
        .field("v", run.velocity, column(nodes, &State::velocity), run.node_weight)
        .field("sigma_11", run.stress_11, column(centres, &State::stress_11), run.cell_weight)
        .field("pressure", run.pressure, column(centres, &State::pressure), run.cell_weight)
        .field("F_22", run.deformation_gradient_22,
               column(centres, &State::deformation_gradient_22), run.cell_weight)
        .value("T_s", surface, exact.surface_temperature())
        .value("T_s - exact [K]", surface - exact.surface_temperature())
        .value("T_s - Kuznetsov-Stewart [K]", surface - small_strain.surface_temperature());
    return result;
}

reports::Study study(const std::string& name, const std::function<Slab(int cells)>& slab) {
    reports::Study study(name);
    study.grids({32, 64, 128, 256})
        .measure([slab](int cells) { return measure(slab(cells), cells); })
        .gate("T", Norm::L2, expect(2.0).within(0.1).from(64),
              "bilinear elements, centred convection; steady, so no time error")
        .gate("v", Norm::L2, expect(2.0).within(0.1).from(64), "follows T");
    study.gate("sigma_11", Norm::L2, expect(2.0).within(0.2).from(64), "x")
        .gate("pressure", Norm::L2, expect(2.0).within(0.2).from(64), "x")
        .gate("F_22", Norm::L2, expect(2.0).within(0.2).from(64), "x")
        .gate("T_s", Norm::magnitude, expect(2.0).within(0.1).from(64), "x")
        .bound("T_s - exact [K]", 128, reports::between(-1.0, 1.0), "x")
        .limit_bound("T_s - exact [K]", 2.0, reports::between(-0.1, 0.1), "x")
        .limit_bound("T_s - Kuznetsov-Stewart [K]", 2.0, reports::between(-100, 100), "model");
    return study;
}

std::vector<reports::Study> studies() {
    return {study("slab, AP, 3 alpha K", [](int cells) { return burning("AP", cells); }),
            study("slab, binder, 3 alpha K", [](int cells) { return burning("binder", cells); }),
            study("slab, AP, alpha K",
                  [](int cells) { return burning("AP", cells).thermal_stress_alpha_k(); }),
            study("slab, binder, alpha K",
                  [](int cells) { return burning("binder", cells).thermal_stress_alpha_k(); })};
}

const Registered here{{.name = "slab",
                       .figure = "-",
                       .shows = "burning slab against its exact solution",
                       .cost = {.verify = 30.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
