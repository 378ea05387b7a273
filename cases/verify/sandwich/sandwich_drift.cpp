/// # Sandwich, 10,000 steps: does the steady state stay?
///
/// Once the sandwich burns steadily nothing should change: not the burn rate, not the balance of
/// forces. Equilibrium is imposed on the whole stress at each step, so its residual cannot pile up;
/// a burn rate that drifts would tell of stress or strain that the moving grid keeps inventing.
/// 10,000 steps burn 1.8 mm, fifteen times the width of the half sandwich, on a coarse grid: drift
/// needs time, not resolution, and the binder has two columns.

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using reports::at_most;
using reports::between;

constexpr int to_steady = 3000;
constexpr int steps = 10000;
constexpr int look_every = 100;

Scene scene(int columns) {
    Scene result = sandwich({"time.step=40 us"});
    result.domain.nx = columns;
    result.domain.ny = 32;
    return result;
}

/// Burns on and returns the mean burn rate of the stretch; the largest residual seen is kept.
double mean_rate(Simulation& simulation, int stretch, double& largest_residual) {
    double sum = 0.0;
    const int looks = stretch / look_every;
    for (int k = 0; k < looks; ++k) {
        run_steps(simulation, look_every);
        const Summary now = simulation.summary();
        sum += now.mean_burn_rate;
        largest_residual = std::max(largest_residual, now.residual);
    }
    return sum / looks;
}

reports::Measurement measure(int columns) {
    Simulation simulation(scene(columns));
    run_steps(simulation, to_steady);
    double residual = 0.0;
    const double first = mean_rate(simulation, steps / 10, residual);
    mean_rate(simulation, 8 * steps / 10, residual);
    const double last = mean_rate(simulation, steps / 10, residual);
    return reports::Measurement(1.0 / columns)
        .value("burn rate, last against first tenth", last / first)
        .value("residual of div sigma", residual);
}

std::vector<reports::Study> studies() {
    reports::Study study("sandwich-drift");
    study.refines("columns", {16})
        .measure(measure)
        .covers({term::stress_advection, term::map_advection, term::equilibrium, term::grid_motion})
        .bound("burn rate, last against first tenth", 16, between(0.999, 1.001),
               "a tenth of a per cent: far below what mechanics does to the burn rate (8 %)")
        .bound("residual of div sigma", 16, at_most(1e-12),
               "round-off of a direct solve, 1e-16 times a condition of 1e4, after every step");
    return {study};
}

const Registered here{
    {.name = "sandwich-drift",
     .figure = "-",
     .shows = "10,000 steps of the steady sandwich: burn rate and balance of forces stay",
     .physics = {physics::sandwich},
     .cost = {.verify = 14.0},
     .studies = studies}};

}  // namespace

}  // namespace crawford
