/// # Thermal sandwich: does heat find its way between two materials?
///
/// A rigid sandwich with a flat surface burns at a prescribed 0.45 cm/s until it is steady. The
/// same heat equation, at rest in the frame of the surface, is solved by
/// reference/thermal_sandwich.hpp with finite elements of degree 8 on a mesh graded towards the
/// corner.
///
/// Flux and q_s rho r_b jump where the interface meets the surface, and T behaves as r ln r there.
/// On 128 x 128 cells that leaves 0.1 K on the surface beside the interface, and less elsewhere.
/// Time steps are long, because the steady state does not depend on them.

#include <algorithm>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/thermal_sandwich.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;

Scene flat(int n) {
    Scene scene = sandwich({"time.step=200 us", "time.end=0.3 s", "surface.burn_rate=0.45 cm/s",
                            "numerics.heat_tolerance=1e-8"});
    scene.domain.nx = n;
    scene.domain.ny = n;
    scene.physics = {.mechanics = false, .reference_map = false, .regression = Regression::fixed};
    return scene;
}

struct Distances {
    double at_corner = 0.0;   ///< where the interface meets the surface [K]
    double on_surface = 0.0;  ///< largest elsewhere on the surface [K]
    double below = 0.0;       ///< largest below it [K]
};

Distances distances(const Simulation& run, const reference::ThermalSandwich& truth,
                    double interface) {
    const Grid& grid = run.grid();
    Distances worst;
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            const double x = std::min(grid.x(i), 120.0 * um);
            const double error = std::abs(run.state().temperature(i, j) -
                                          truth.temperature(x, std::min(grid.eta(j), 0.0)));
            const bool surface = j == grid.rows();
            const bool corner = surface && std::abs(x - interface) < 0.5 * grid.dx();
            double& kind = corner ? worst.at_corner : surface ? worst.on_surface : worst.below;
            kind = std::max(kind, error);
        }
    return worst;
}

reports::Measurement measure(int n) {
    Simulation run(flat(n));
    run_to_end(run);
    const auto geometry = reference::paper_sandwich();
    const reference::ThermalSandwich truth(geometry, reference::paper_heating());
    const Distances worst = distances(run, truth, geometry.strip);
    return reports::Measurement(1.0 / n)
        .value("|T - truth|, interface at the surface [K]", worst.at_corner)
        .value("|T - truth|, largest elsewhere on the surface [K]", worst.on_surface)
        .value("|T - truth|, largest below [K]", worst.below);
}

std::vector<reports::Study> studies() {
    reports::Study study("sandwich-thermal");
    study.refines("columns", {128})
        .measure(measure)
        .covers({term::heat_convection, term::heat_conduction, term::heat_interface, term::gas_flux,
                 term::reaction_flux, term::clustering})
        .bound("|T - truth|, interface at the surface [K]", 128, at_most(0.3),
               "r ln r at one point, a node of either grid")
        .bound("|T - truth|, largest elsewhere on the surface [K]", 128, at_most(0.3),
               "0.05 % of the rise, three times what the grid leaves")
        .bound("|T - truth|, largest below [K]", 128, at_most(0.3),
               "0.05 % of the rise, three times what the grid leaves");
    return {study};
}

const Registered here{{.name = "sandwich-thermal",
                       .figure = "-",
                       .shows = "steady rigid sandwich against high-order elements",
                       .physics = {physics::sandwich},
                       .cost = {.verify = 4.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
