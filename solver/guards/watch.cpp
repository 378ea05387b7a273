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

/// \throws NumericalFailure beyond the limit: HeatStep itself ends a run only where it is lost.
void check_coupling(const Simulation& simulation, double coupling) {
    const Scene& scene = simulation.scene();
    const double limit = coupling_limit(scene.time.scheme);
    if (coupling < limit) return;
    const std::string condition = coupling_condition(scene.numerics.coupling, scene.time.scheme);
    throw NumericalFailure(
        {.kind = FailureFields::Kind::beyond_limit,
         .module = "heat",
         .quantity = "coupling number g",
         .value = coupling,
         .limit = FailureLimit{.value = limit, .condition = condition},
         .step = simulation.state().step,
         .time = simulation.state().time,
         .advice = scene.numerics.coupling == Coupling::lagged
                       ? "take numerics.coupling = \"adiabatic\""
                       : "take the same numerics.stress_work as numerics.thermal_stress"});
}

}  // namespace

std::optional<Guard> Worst::meet(double value) {
    if (!(value > value_)) return std::nullopt;
    value_ = value;
    if (told_) return std::nullopt;
    Guard guard = judge_(value);
    told_ = guard.beyond != Beyond::nothing;
    return told_ ? std::optional(std::move(guard)) : std::nullopt;
}

Watch::Watch(const Simulation& simulation)
    : narrowest_(narrowest_column(simulation.grid())), surface_(simulation.state().surface) {
    const Grid& grid = simulation.grid();
    rows_in_a_metre_.resize(size_t(grid.rows()) + 1);
    for (int j = 0; j <= grid.rows(); ++j)
        rows_in_a_metre_[size_t(j)] = 1.0 / std::min(grid.height(std::max(j - 1, 0)),
                                                     grid.height(std::min(j, grid.rows() - 1)));
    watch(simulation.scene(), grid);
}

void Watch::watch(const Scene& scene, const Grid& grid) {
    const auto add = [&](const char* name, Worst::Judge judge) {
        worst_.emplace(name, std::move(judge));
    };
    if (scene.physics.heat && scene.physics.mechanics)
        add("coupling", [limit = coupling_limit(scene.time.scheme)](double value) {
            return Guard{.name = "coupling", .value = value, .limit = limit};
        });
    if (scene.physics.heat) {
        add("undershoot", undershoot);
        add("relaxation", [scene](double value) { return relaxation(value, scene); });
        add("cell_peclet", [scene, grid](double burn_rate) {
            Guard worst = cell_peclet(grid, scene.morphology.materials.front(), burn_rate);
            Guard other = cell_peclet(grid, scene.morphology.materials.back(), burn_rate);
            return is_worse(other, worst) ? other : worst;
        });
    }
    if (scene.physics.regression == Regression::pyrolysis) add("alternation", alternation);
    add("crossing_y", crossing_y);
    if (grid.cell_columns() == 1) return;
    add("crossing_x", crossing_x);
    add("front_crossing", front_crossing);
    add("slope", slope);
}

Watch::Crossed Watch::crossed(const Simulation& simulation, const Summary& summary) {
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    const double dt = state.length;
    Crossed worst;
    for (int i = 0; i < grid.node_columns(); ++i) {
        const double fall = surface_[size_t(i)] - state.surface[size_t(i)];
        worst.rows = std::max(worst.rows, std::abs(fall) * rows_in_a_metre_.back());
        if (state.velocity.empty()) continue;
        const double across = dt / narrowest_;
        for (int j = 0; j <= grid.rows(); ++j) {
            const Vector& v = state.velocity(i, j);
            worst.columns = std::max(worst.columns, std::abs(v.x()) * across);
            worst.rows =
                std::max(worst.rows, std::abs(v.y() * dt + fall) * rows_in_a_metre_[size_t(j)]);
        }
    }
    worst.slope = largest_slope(grid, state.surface);
    worst.of_surface =
        summary.mean_burn_rate * dt / narrowest_ * worst.slope / std::hypot(1.0, worst.slope);
    surface_ = state.surface;
    return worst;
}

/// The least of the last turns, if there was nothing but turns.
double Watch::turning(double burn_rate) {
    burn_rates_.push_back(burn_rate);
    if (burn_rates_.size() > turns + 2) burn_rates_.erase(burn_rates_.begin());
    if (burn_rates_.size() < turns + 2 || burn_rate <= 0.0) return 0.0;
    double least = std::abs(burn_rates_[1] - burn_rates_[0]);
    for (size_t k = 2; k < burn_rates_.size(); ++k) {
        const double change = burn_rates_[k] - burn_rates_[k - 1];
        if (change * (burn_rates_[k - 1] - burn_rates_[k - 2]) >= 0.0) return 0.0;
        least = std::min(least, std::abs(change));
    }
    return least / burn_rate;
}

Guards Watch::record(const Simulation& simulation, const Summary& summary) {
    Guards told;
    const auto meet = [&](std::string_view name, double value) {
        const auto worst = worst_.find(name);
        if (worst == worst_.end()) return;
        if (auto guard = worst->second.meet(value)) told.push_back(std::move(*guard));
    };
    const StepNumbers numbers = simulation.step_numbers();
    if (simulation.scene().physics.mechanics) check_coupling(simulation, numbers.coupling);
    meet("coupling", numbers.coupling);
    meet("relaxation", numbers.contraction);
    meet("undershoot", simulation.scene().bottom.temperature - summary.least_temperature);
    meet("cell_peclet", summary.mean_burn_rate);
    meet("alternation", turning(summary.mean_burn_rate));
    const Crossed cells = crossed(simulation, summary);
    meet("crossing_y", cells.rows);
    meet("crossing_x", cells.columns);
    meet("front_crossing", cells.of_surface);
    meet("slope", cells.slope);
    return told;
}

Guards Watch::met() const {
    Guards met;
    for (const auto& [name, worst] : worst_) met.push_back(worst.guard());
    return met;
}

}  // namespace crawford
