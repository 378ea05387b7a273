/// # Conservation: does all heat, mass and force go somewhere?
///
/// Nothing here is compared with a solution. What has come in through the surface must be found
/// again, whatever the fields look like:
///
/// - heat: what is stored is the flux that came in, less what the regressing surface carries off,
///   less what v carries, less the stress work;
/// - mass: rho times the area that the surface sweeps is rho r_b, summed over surface and time;
/// - force: every row of cells carries p_c times the width.
///
/// Each is summed up here from the fields of successive steps, by cases/verify/coupled/balance.hpp,
/// with a quadrature and a table of materials of its own. That closes as follows.
///
/// Heat. Summed over all nodes, conduction cancels between them, and the centred convection of a
/// column, sum of (w_j + w_j+1)/2 (T_j+1 - T_j), with the stress work's sum of (T_j + T_j+1)/2
/// (v_j+1 - v_j), is a boundary term by summation by parts: in space nothing is lost although the
/// scheme is not in conservation form. That is why the steady slab's T_s is exact to a mK on any
/// grid. In time, convection and stress work take r_b and v of the step's beginning, the surface
/// moves with r_b of its end, and trapezoids lie between: dt/2 times the change of each, order 1
/// until the slab is steady and nothing changes; then round-off. A sandwich deforms across its
/// slopes too, where corners and centres differ by order 2 in the cell, and more beside the corner:
/// its balance is bounded, not gated by an order.
///
/// Mass. The surface moves by r_b times WENO's slope, the flux of mass is counted along straight
/// segments: exact on a flat surface but for the dt/2 above. The notch that burns along the
/// interface is a kink, so a sandwich closes at a first order in the cell: its bound.
///
/// Force is exact whatever the grid: the test function that lifts all above a row is linear, and
/// the projection satisfies it to the round-off of a direct solve. (Without the Kelvin-Voigt stress
/// of burning corners, which is part of the balance and not of the stress.)

#include <cmath>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/coupled/balance.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr auto heat = "heat missing, of what came in";
constexpr auto heat_at_last = "heat missing in the last step, of what came in";
constexpr auto mass = "mass missing, of what burnt";
constexpr auto force = "force missing, of the load";

reports::Measurement measure(Scene scene, int steps) {
    scene.time.step = scene.time.end / steps;
    Simulation simulation(scene);
    Account all;
    Account last;
    Instant before = look(simulation);
    const Observer account = [&](const Simulation& burning, double) {
        const Instant now = look(burning);
        last = {};
        last.add(before, now, scene.time.step);
        all.add(before, now, scene.time.step);
        before = now;
    };
    run_steps(simulation, steps, {account});
    return reports::Measurement(1.0 / steps)
        .value(heat, all.missing / all.in)
        .value(mass, all.unswept / all.burnt)
        .value(heat_at_last, std::abs(last.missing / last.in))
        .value(force, force_lost(simulation));
}

/// A slab that is long steady when it ends: its thermal layer takes 10 ms. So deep that no heat
/// leaves through the bottom.
Scene steady_slab(const std::string& material, double flux) {
    Scene scene = slab(material, {.cells = 64, .clustering = 2.0, .depth = 1200.0 * um})
                      .burning_by_law()
                      .heated(flux)
                      .pressed(2.0 * MPa)
                      .scene();
    scene.time.end = 0.3;
    return scene;
}

Scene short_sandwich() {
    Scene scene = sandwich({"domain.nx=32", "domain.ny=48", "time.end=8 ms"});
    scene.numerics.viscous_time = 0.0;
    return scene;
}

reports::Study balances(const std::string& name, const Scene& scene, std::vector<int> steps) {
    const auto first = expect(1.0).within(0.05);
    const int finest = steps.back();
    reports::Study study(name);
    study.refines("steps", std::move(steps))
        .measure([scene](int n) { return measure(scene, n); })
        .covers({term::heat_storage, term::heat_convection, term::heat_conduction,
                 term::heat_interface, term::stress_work, term::gas_flux, term::reaction_flux,
                 term::pyrolysis, term::surface_motion, term::slope, term::grid_motion,
                 term::equilibrium, term::traction, term::time_step})
        .difference_gate(heat, Norm::magnitude, first,
                         "r_b, v and the surface are taken at different ends of a step")
        .difference_gate(mass, Norm::magnitude, first, "the surface moves at the r_b of the end")
        .bound(force, finest, at_most(1e-12), "round-off of a direct solve");
    return study;
}

reports::Study slab_balances(const std::string& material, double flux) {
    reports::Study study = balances("conservation, " + material + " slab",
                                    steady_slab(material, flux), {1500, 3000, 6000});
    study
        .limit_bound(heat, 1.0, between(-1e-5, 1e-5),
                     "a column loses nothing in space; dT/dt begins as t^-1/2, of which trapezoids "
                     "leave dt^1/2")
        .limit_bound(mass, 1.0, between(-1e-6, 1e-6), "a flat surface sweeps what it burns")
        .bound(heat_at_last, 6000, at_most(1e-7), "steady: what is left of the transient");
    return study;
}

reports::Study sandwich_balances() {
    reports::Study study =
        balances("conservation, sandwich", short_sandwich(), {100, 200, 400, 800});
    study
        .limit_bound(heat, 1.0, between(-2e-4, 2e-4),
                     "corners against centres, on slopes, in cells of 7.5 um")
        .limit_bound(mass, 1.0, between(-6e-4, 6e-4),
                     "the notch along the interface: one cell of 16, its slope known to h");
    return study;
}

std::vector<reports::Study> studies() {
    return {slab_balances("AP", 200.0 * cal / (s * cm2)),
            slab_balances("binder", 160.0 * cal / (s * cm2)), sandwich_balances()};
}

const Registered here{{.name = "conservation",
                       .figure = "-",
                       .shows = "heat, mass and force of burning slabs and a sandwich balance",
                       .physics = {physics::slab, physics::sandwich},
                       .cost = {.verify = 8.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
