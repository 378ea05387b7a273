/// # Thermal sandwich: does heat find its way between two materials?
///
/// A rigid sandwich with a flat surface burns at a prescribed 0.45 cm/s until it is steady. The
/// same heat equation, at rest in the frame of the surface, is solved by
/// reference/thermal_sandwich.hpp with finite elements of degree 8 on a mesh graded towards the
/// corner.
///
/// Flux and q_s rho r_b jump where the interface meets the surface, and T behaves as r ln r there:
/// that one point is held to 5 K, all others to 1.5 K. Time steps are long, because the steady
/// state does not depend on them.

#include <algorithm>
#include <cmath>

#include "cases/catalogue/registry.hpp"
#include "cases/catalogue/sandwich.hpp"
#include "cases/catalogue/units.hpp"
#include "reference/thermal_sandwich.hpp"
#include "solver/simulation/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;

Scene flat(int n) {
    Scene scene = sandwich({"time.step=100 us", "time.end=0.4 s", "surface.burn_rate=0.45 cm/s",
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
    while (run.state().time < run.scene().time.end) run.step();
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
    study.grids({128})
        .measure(measure)
        .bound("|T - truth|, interface at the surface [K]", 128, at_most(5.0),
               "r ln r at one point")
        .bound("|T - truth|, largest elsewhere on the surface [K]", 128, at_most(1.5),
               "a quarter of a percent of the rise")
        .bound("|T - truth|, largest below [K]", 128, at_most(1.5),
               "a quarter of a percent of the rise");
    return {study};
}

const Registered here{{.name = "sandwich-thermal",
                       .figure = "-",
                       .shows = "steady rigid sandwich against high-order elements",
                       .cost = {.verify = 10.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
