#include "solver/guards/watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/guards/burning_guards.hpp"
#include "solver/guards/grid_guards.hpp"
#include "solver/heat/coupling_number.hpp"

namespace crawford {

namespace {

// A burn rate that goes up and down this often in a row does not do so by chance: a disc that comes
// out turns it once.
constexpr size_t turns = 8;

}  // namespace

Watch::Watch(const Simulation& simulation)
    : narrowest_(narrowest_column(simulation.grid())), surface_(simulation.state().surface) {
    const Grid& grid = simulation.grid();
    rate_of_rows_.resize(size_t(grid.rows()) + 1);
    for (int j = 0; j <= grid.rows(); ++j)
        rate_of_rows_[size_t(j)] = 1.0 / std::min(grid.height(std::max(j - 1, 0)),
                                                  grid.height(std::min(j, grid.rows() - 1)));
}

Watch::Crossed Watch::crossed(const Simulation& simulation, const Summary& summary) {
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    const double dt = simulation.scene().time.step;
    Crossed worst;
    for (int i = 0; i < grid.node_columns(); ++i) {
        const double fall = surface_[size_t(i)] - state.surface[size_t(i)];
        worst.rows = std::max(worst.rows, std::abs(fall) * rate_of_rows_.back());
        if (state.velocity.empty()) continue;
        const double across = dt / narrowest_;
        for (int j = 0; j <= grid.rows(); ++j) {
            const Vector& v = state.velocity(i, j);
            worst.columns = std::max(worst.columns, std::abs(v.x()) * across);
            worst.rows =
                std::max(worst.rows, std::abs(v.y() * dt + fall) * rate_of_rows_[size_t(j)]);
        }
    }
    for (int i = 0; i < grid.cell_columns(); ++i)
        worst.slope = std::max(worst.slope, std::abs(grid.slope(state.surface, i)));
    worst.of_surface =
        summary.mean_burn_rate * dt / narrowest_ * worst.slope / std::hypot(1.0, worst.slope);
    surface_ = state.surface;
    return worst;
}

/// The least of the last turns, if there was nothing but turns.
double Watch::alternation(double burn_rate) {
    burn_rates_.push_back(burn_rate);
    if (burn_rates_.size() > turns + 2) burn_rates_.pop_front();
    if (burn_rates_.size() < turns + 2 || burn_rate <= 0.0) return 0.0;
    double least = std::abs(burn_rates_[1] - burn_rates_[0]);
    for (size_t k = 2; k < burn_rates_.size(); ++k) {
        const double change = burn_rates_[k] - burn_rates_[k - 1];
        if (change * (burn_rates_[k - 1] - burn_rates_[k - 2]) >= 0.0) return 0.0;
        least = std::min(least, std::abs(change));
    }
    return least / burn_rate;
}

void Watch::check_coupling(const Simulation& simulation, double coupling) const {
    const Scene& scene = simulation.scene();
    const double limit = coupling_limit(scene.time.scheme);
    if (coupling < limit) return;
    throw NumericalFailure(
        {.kind = FailureFields::Kind::beyond_limit,
         .module = "heat",
         .quantity = "coupling number g",
         .value = coupling,
         .limit = FailureLimit{.value = limit,
                               .condition =
                                   coupling_condition(scene.numerics.coupling, scene.time.scheme)},
         .step = simulation.state().step,
         .time = simulation.state().time,
         .advice = scene.numerics.coupling == Coupling::lagged
                       ? "take numerics.coupling = \"adiabatic\""
                       : "take the same numerics.stress_work as numerics.thermal_stress"});
}

Guards Watch::take(const Guards& now) {
    Guards beyond;
    for (const Guard& guard : now) {
        const auto worst = std::ranges::find(met_, guard.name, &Guard::name);
        const bool before = worst != met_.end() && worst->beyond != Beyond::nothing;
        if (guard.beyond != Beyond::nothing && !before) beyond.push_back(guard);
        if (worst == met_.end())
            met_.push_back(guard);
        else if (is_worse(guard, *worst))
            *worst = guard;
    }
    return beyond;
}

Guards Watch::record(const Simulation& simulation, const Summary& summary) {
    const Scene& scene = simulation.scene();
    Guards now;
    if (scene.physics.heat) {
        const StepNumbers numbers = simulation.step_numbers();
        if (scene.physics.mechanics) {
            check_coupling(simulation, numbers.coupling);
            now.push_back({.name = "coupling",
                           .value = numbers.coupling,
                           .limit = coupling_limit(scene.time.scheme)});
        }
        now.push_back(relaxation(numbers.contraction, scene));
        now.push_back(
            undershoot(std::max(0.0, scene.bottom.temperature - summary.least_temperature)));
    }
    const Crossed cells = crossed(simulation, summary);
    now.push_back(crossing_y(cells.rows));
    if (simulation.grid().cell_columns() > 1) {
        now.push_back(crossing_x(cells.columns));
        now.push_back(front_crossing(cells.of_surface));
        now.push_back(slope(cells.slope));
    }
    if (scene.physics.regression == Regression::pyrolysis)
        now.push_back(crawford::alternation(alternation(summary.mean_burn_rate)));
    // A window is deep enough, and a row low enough, for what burns in it now.
    if (scene.physics.heat && summary.mean_burn_rate > 0.0)
        for (const Material& m : scene.morphology.materials) {
            now.push_back(fourier(scene, simulation.grid(), m));
            now.push_back(cell_peclet(simulation.grid(), m, summary.mean_burn_rate));
        }
    return take(now);
}

}  // namespace crawford
