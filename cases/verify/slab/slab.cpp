/// # Slab: how exact is the solver where the exact solution is known?
///
/// A homogeneous slab that regresses steadily at 0.45 cm/s has a closed-form solution
/// (reference/slab.hpp) of the very equations the solver discretises: constant density, convection
/// with r_b + v, stress work -beta T div v. The truth shares neither code nor table of materials
/// with the solver, and a second, independent integration by shooting agrees with it to 1e-10. The
/// steady state does not depend on the time step, so what is left is the error in space. It is read
/// on the clustered grid that real scenes burn on.
///
/// Stress enters the window with zero normal gradient: it keeps what the first moments left there.
/// Heat that reaches the bottom would make that drift. The slab is therefore 1200 um deep, stress is
/// compared relative to what enters, and what enters is bounded by itself.
///
/// Kuznetsov and Stewart's small-strain solution is another model and not another truth: the
/// distance to it tends to the distance of the two models, and no grid makes it smaller.

#include "cases/scenes/slab.hpp"

#include "cases/columns.hpp"
#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/slab.hpp"
#include "reference/truth_of.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::SlabModel;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double pressure = 2.0 * MPa;
constexpr auto entering = "sigma_11 that enters - exact [Pa]";
constexpr auto error = "T_s - exact [K]";
constexpr auto distance = "T_s - Kuznetsov-Stewart [K]";

Slab burning(const std::string& material, double flux, int cells) {
    return slab(material, {.cells = cells, .clustering = 2.0, .depth = 1200.0 * um})
        .regressing(0.45 * cm / s)
        .heated(flux)
        .pressed(pressure);
}

reports::Measurement measure(const Slab& slab, int cells) {
    const SlabProfile run = burn_to_steady(slab.scene());
    const reference::Slab exact(slab.conditions(SlabModel::eulerian));
    const reference::Slab small_strain(slab.conditions(SlabModel::kuznetsov_stewart));
    const auto truth = reference::truth_of(exact);
    const auto nodes = truth.values(reference::points_at(run.node_y));
    const auto centres = truth.values(reference::points_at(run.cell_y));
    const auto stress = centres.column("stress_xx");
    const double surface = run.temperature.back();

    reports::Measurement result(1.0 / cells);
    result.field("T", run.temperature, nodes.column("temperature"), run.node_weight)
        .field("v", run.velocity, nodes.column("velocity_y"), run.node_weight)
        .field("sigma_11", above_first(run.stress_11), above_first(stress), run.cell_weight)
        .field("pressure", above_first(run.pressure), above_first(centres.column("pressure")),
               run.cell_weight)
        .field("F_22", run.deformation_gradient_22, centres.column("deformation_gradient_yy"),
               run.cell_weight)
        .value(entering, run.stress_11.front() - stress.front())
        .value(error, surface - exact.surface_temperature())
        .value(distance, surface - small_strain.surface_temperature());
    return result;
}

reports::Study study(const std::string& name, const std::function<Slab(int cells)>& slab) {
    const auto surface = [&](SlabModel model) {
        return reference::Slab(slab(1).conditions(model)).surface_temperature();
    };
    const double models = surface(SlabModel::eulerian) - surface(SlabModel::kuznetsov_stewart);
    const auto order = expect(2.0).within(0.1).from(64);
    const auto stress = expect(2.0).or_better(0.1).from(64).scattering(0.4);

    reports::Study study(name);
    study.refines("rows", {32, 64, 128, 256})
        .measure([slab](int cells) { return measure(slab(cells), cells); })
        .covers({term::heat_convection, term::heat_conduction, term::stress_work, term::gas_flux,
                 term::elasticity, term::stress_advection, term::thermal_stress, term::equilibrium,
                 term::traction, term::support, term::map_advection, term::deformation,
                 term::clustering, term::grid_motion})
        .gate("T", Norm::L2, order, "bilinear elements, centred convection; steady: no time error")
        .gate("T", Norm::Linf, order, "the same at the worst node: the profile is smooth")
        .gate("v", Norm::L2, order, "v = r_b expm1(theta (T - T0)) follows T")
        .gate("sigma_11", Norm::L2, stress,
              "2 from the thermal stress; the 3 of WENO3 dominates on coarse grids and fades")
        .gate("pressure", Norm::L2, stress, "as sigma_11: sigma_22 is exact")
        .gate("F_22", Norm::L2, order,
              "ENO2 never changes its stencil on a convex profile; F by centred differences")
        .bound(entering, 256, between(-1e-3 * pressure, 1e-3 * pressure),
               "adiabatic heating by the first loading stays in what enters; 0.1 % of p_c")
        .bound(error, 128, between(-2e-3, 2e-3),
               "the discrete balance of heat is the slab's own: only the stretch has an error")
        .limit_bound(distance, 2.0, between(models - 0.01, models + 0.01),
                     "model error, not the grid's: so far are the two exact solutions apart");
    return study;
}

std::vector<reports::Study> studies() {
    const auto ap = [](int cells) { return burning("AP", 200.0 * cal / (s * cm2), cells); };
    const auto binder = [](int cells) { return burning("binder", 100.0 * cal / (s * cm2), cells); };
    const auto alpha_k = [](const auto& slab) {
        return [slab](int cells) { return slab(cells).thermal_stress_alpha_k(); };
    };
    return {study("slab, AP, beta = 3 alpha K", ap), study("slab, AP, beta = alpha K", alpha_k(ap)),
            study("slab, binder, beta = 3 alpha K", binder),
            study("slab, binder, beta = alpha K", alpha_k(binder))};
}

const Registered here{{.name = "slab",
                       .figure = "-",
                       .shows = "burning slab against its exact solution",
                       .physics = {physics::slab},
                       .cost = {.verify = 30.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
