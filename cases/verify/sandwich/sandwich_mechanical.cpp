/// # Mechanical sandwich: does a cold sandwich deform as elasticity says?
///
/// One quasi-static step presses 2 MPa onto the flat surface of a sandwich at rest, clamped at the
/// bottom. From a stress-free state that is linear elasticity, displacement = velocity x dt, and
/// reference/elastic_sandwich.hpp solves it by finite elements of degree 8 on a mesh graded towards
/// the corner: no code, no element and no mesh in common.
///
/// The binder is nearly incompressible (K/mu = 4268): an element that locks shows it here. The
/// fully integrated q1 misses the deflection at the centre of the binder by 2.4 %, ten times as
/// much as B-bar. Where interface and surface meet the stress is singular, r^-0.405, and every
/// method on a uniform grid converges slowly near it, so what is gated are displacements, and the
/// pressure away from it, on 128 x 256 cells.

#include <algorithm>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/elastic_sandwich.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;
using reports::between;

constexpr double pressure = 2.0 * MPa;
constexpr double interface = 30.0 * um;

/// Grid lines lie on the interface, x = 30 um, where nx is a multiple of 8.
Scene pressed(int nx) {
    Scene scene = sandwich({"domain.clustering=0", "bottom.support=clamped", "time.end=20 us"});
    scene.domain.nx = nx;
    scene.domain.ny = 2 * nx;
    scene.physics = {.heat = false, .reference_map = false, .regression = Regression::none};
    scene.numerics.viscous_time.reset();  // it follows what burns
    return scene;
}

/// The whole sandwich after one step, read at nodes and cells.
class Pressed {
public:
    explicit Pressed(int nx) : simulation_(pressed(nx)) { run_steps(simulation_, 1); }

    /// Displacement [m] of the node nearest to (x, y).
    Vector displacement(double x, double y) const {
        const Grid& grid = simulation_.grid();
        const int i = int(std::lround((x - grid.x(0)) / grid.dx()));
        const int j = int(std::lround((y + grid.depth()) / grid.height(0)));
        return simulation_.state().velocity(i, j) * simulation_.scene().time.step;
    }

    /// Pressure [Pa] at a node: the mean of the cells around it, on the axis of those to its right.
    double pressure(double y) const {
        const Grid& grid = simulation_.grid();
        const int j = int(std::lround((y + grid.depth()) / grid.height(0)));
        const CellField& p = simulation_.state().stress.pressure;
        return 0.5 * (p(0, j - 1) + p(0, j));
    }

private:
    Simulation simulation_;
};

double percent(double value, double truth) {
    return 100.0 * (value / truth - 1.0);
}

/// Largest error of u along the interface, over the largest u there [%].
double worst_along_interface(const Pressed& run, const reference::ElasticSandwich& truth) {
    double error = 0.0;
    double largest = 0.0;
    for (int depth = 0; depth <= 480; depth += 15) {
        const double exact = truth.displacement(interface, -depth * um).x();
        const double found = run.displacement(interface, -depth * um).x();
        error = std::max(error, std::abs(found - exact));
        largest = std::max(largest, std::abs(exact));
    }
    return 100.0 * error / largest;
}

reports::Measurement measure(int nx) {
    const reference::ElasticSandwich truth(reference::paper_sandwich(), pressure,
                                           reference::Support::clamped);
    const Pressed run(nx);
    const auto along = [&](double x, double y, int axis) {
        return percent(run.displacement(x, y)[axis], truth.displacement(x, y)[axis]);
    };
    return reports::Measurement(1.0 / nx)
        .value("v, AP surface at x = 120 um [%]", along(120.0 * um, 0.0, 1))
        .value("v, binder surface at x = 0 [%]", along(0.0, 0.0, 1))
        .value("u, interface 15 um deep [%]", along(interface, -15.0 * um, 0))
        .value("u, largest error along the interface [%]", worst_along_interface(run, truth))
        .value("p, binder axis 120 um deep [%]",
               percent(run.pressure(-120.0 * um), truth.pressure(0.0, -120.0 * um)));
}

std::vector<reports::Study> studies() {
    reports::Study study("sandwich-mechanical");
    study.refines("columns", {128})
        .measure(measure)
        .covers({term::elasticity, term::equilibrium, term::traction, term::support,
                 term::elastic_interface, term::incompressibility})
        .bound("v, AP surface at x = 120 um [%]", 128, between(-0.5, 0.5), "far from the corner")
        .bound("v, binder surface at x = 0 [%]", 128, between(-1.0, 1.0),
               "16 cells from the singular corner")
        .bound("u, interface 15 um deep [%]", 128, between(-3.0, 3.0), "8 cells from the corner")
        .bound("u, largest error along the interface [%]", 128, at_most(3.0),
               "u grows as r^0.595 from the corner, which no uniform grid follows")
        .bound("p, binder axis 120 um deep [%]", 128, between(-1.0, 1.0),
               "K/mu = 4268 multiplies any error of div u");
    return {study};
}

const Registered here{{.name = "sandwich-mechanical",
                       .figure = "-",
                       .shows = "cold sandwich against high-order elements",
                       .physics = {physics::sandwich},
                       .cost = {.verify = 2.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
