/// # Slab that burns by its own law: does it find its temperature and its burn rate?
///
/// Where the burn rate is not given it follows from the surface temperature, r_b = A exp(-Ea/(R
/// T_s)), and pyrolysis takes q_s rho r_b out of the heat that enters. A steady slab then has one
/// temperature at which what enters is what the rising solid needs, r_b g(T_s - T_0) = Q + q_s rho
/// r_b. reference/slab.hpp finds it by root finding on the closed form and
/// reference/slab_shooting.hpp by shooting on the differential equations; neither shares code, law
/// or table of materials with the solver.
///
/// The slab starts cold, is heated until it ignites, and burns until nothing changes; the steady
/// state does not depend on the time step, so what is left is the error in space, on the clustered
/// grid that real scenes burn on. It is 1200 um deep for the reasons of cases/verify/slab/slab.cpp.
/// The burn rate is read from the surface as it moves, not from the law. Summed over the column,
/// the discrete equations leave the very balance above (see cases/verify/coupled/conservation.cpp):
/// T_s is exact but for the error of the stretch r_b + v, some mK, while the profile below it is of
/// order 2.
///
/// Three grids suffice: the order is 2.00 from the first pair on, and cases/verify/slab/slab.cpp
/// goes on to 256. It prescribes r_b and lets pyrolysis absorb nothing: it cannot see a wrong q_s,
/// a missing rho beside it, a wrong A or Ea, nor a surface that moves at another rate than its law.

#include <limits>

#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/slab.hpp"
#include "reference/slab_shooting.hpp"
#include "reference/truth_of.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr auto temperature_error = "T_s - exact [K]";
constexpr auto rate_error = "r_b/exact - 1";
constexpr auto truths_apart = "T_s, closed form - shooting [K]";

Slab burning(const std::string& material, double flux, int cells) {
    return slab(material, {.cells = cells, .clustering = 2.0, .depth = 1200.0 * um})
        .burning_by_law()
        .heated(flux)
        .pressed(2.0 * MPa);
}

reports::Measurement measure(const Slab& slab, int cells) {
    const SlabProfile run = burn_to_steady(slab.scene());
    auto conditions = slab.conditions(reference::SlabModel::eulerian);
    const reference::Slab exact(conditions);
    conditions.depth = std::numeric_limits<double>::infinity();
    const reference::SlabShooting shot(conditions);
    const auto nodes = reference::truth_of(exact).values(reference::points_at(run.node_y));
    const double surface = run.temperature.back();
    return reports::Measurement(1.0 / cells)
        .field("T", run.temperature, nodes.column("temperature"), run.node_weight)
        .field("v", run.velocity, nodes.column("velocity_y"), run.node_weight)
        .value(temperature_error, surface - exact.surface_temperature())
        .value(rate_error, run.burn_rate / exact.burn_rate() - 1.0)
        .value(truths_apart, exact.surface_temperature() - shot.surface_temperature());
}

reports::Study study(const std::string& name, const std::string& material, double flux) {
    const auto order = expect(2.0).within(0.05);

    reports::Study study(name);
    study.refines("rows", {32, 64, 128})
        .measure([=](int cells) { return measure(burning(material, flux, cells), cells); })
        .covers({term::heat_convection, term::heat_conduction, term::stress_work, term::gas_flux,
                 term::reaction_flux, term::elasticity, term::thermal_stress, term::pyrolysis,
                 term::surface_motion, term::clustering, term::grid_motion})
        .gate("T", Norm::L2, order, "bilinear elements, centred convection; steady: no time error")
        .gate("T", Norm::Linf, order, "the same at the worst node: the profile is smooth")
        .gate("v", Norm::L2, order, "v = r_b expm1(theta (T - T0)) follows T and r_b")
        .bound(temperature_error, 64, between(-2e-3, 2e-3),
               "the discrete balance of heat is the slab's own: only the stretch has an error")
        .bound(rate_error, 64, between(-2e-5, 2e-5), "Ea/(R T_s^2) = 0.01/K times 2 mK")
        .bound(truths_apart, 128, between(-1e-6, 1e-6),
               "two roads to one truth, 1e-10 apart; the bottom is 20 e-foldings down");
    return study;
}

std::vector<reports::Study> studies() {
    return {study("slab-burning-law, AP", "AP", 200.0 * cal / (s * cm2)),
            study("slab-burning-law, binder", "binder", 160.0 * cal / (s * cm2))};
}

const Registered here{{.name = "slab-burning-law",
                       .figure = "-",
                       .shows = "slab that burns by its law against its exact solution",
                       .physics = {physics::slab},
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
