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

template <class Judge>
Guard worst_of(const Scene& scene, Judge judge) {
    const std::vector<Material>& materials = scene.morphology.materials;
    Guard worst = judge(materials.front());
    Guard other = judge(materials.back());
    return is_worse(other, worst) ? other : worst;
}

const Material& with_largest_diffusivity(const Scene& scene) {
    return *std::ranges::max_element(scene.morphology.materials, {}, &Material::diffusivity);
}

/// Of the material that follows its burning worst.
double largest_front_coupling(const Simulation& simulation, const Summary& summary) {
    const Scene& scene = simulation.scene();
    const SteadySlab burning{summary.largest_temperature, summary.mean_burn_rate};
    double largest = 0.0;
    for (const Material& m : scene.morphology.materials)
        largest =
            std::max(largest, front_coupling_number(scene, m, burning, simulation.state().length));
    return largest;
}

}  // namespace

std::optional<Guard> Worst::meet(double value) {
    if (!(worst_ == Is::largest ? value > value_ : value < value_)) return std::nullopt;
    value_ = value;
    if (told_) return std::nullopt;
    Guard guard = judge_(value);
    told_ = guard.beyond != Beyond::nothing;
    return told_ ? std::optional(std::move(guard)) : std::nullopt;
}

Watch::Watch(const Simulation& simulation)
    : crossing_(simulation.scene(), simulation.grid()),
      surface_(simulation.state().surface),
      diffusivity_(largest_diffusivity(simulation.scene().morphology.materials)) {
    watch(simulation.scene(), simulation.grid());
}

void Watch::watch(const Scene& scene, const Grid& grid) {
    const auto add = [&](const char* name, Worst::Judge judge) {
        worst_.emplace(name, Worst(std::move(judge)));
    };
    if (scene.physics.heat) watch_heat(scene, grid);
    if (scene.physics.heat && scene.physics.mechanics)
        add("coupling", [limit = coupling_limit(scene.time.scheme)](double value) {
            return Guard{.name = "coupling", .value = value, .limit = limit};
        });
    if (scene.physics.mechanics)
        add("pressing", [scene, grid](double) {
            return worst_of(scene, [&](const Material& m) { return pressing(scene, grid, m); });
        });
    if (scene.physics.regression == Regression::pyrolysis) add("alternation", alternation);
    add("crossing_y", crossing_y);
    if (grid.cell_columns() == 1) return;
    add("crossing_x", crossing_x);
    add("front_crossing",
        [scheme = scene.time.scheme](double columns) { return front_crossing(columns, scheme); });
    add("slope", slope);
}

void Watch::watch_heat(const Scene& scene, const Grid& grid) {
    worst_.emplace("undershoot", Worst(undershoot));
    worst_.emplace("relaxation", Worst([scene](double value) { return relaxation(value, scene); }));
    worst_.emplace("cell_peclet", Worst([scene, grid](double burn_rate) {
                       return worst_of(scene, [&](const Material& m) {
                           return cell_peclet(grid, m, burn_rate);
                       });
                   }));
    worst_.emplace("fourier", Worst([scene, grid](double dt) {
                       return fourier(fourier_number(grid, with_largest_diffusivity(scene), dt));
                   }));
    if (scene.physics.regression == Regression::none) return;
    worst_.emplace("front_coupling", Worst([](double number) { return front_coupling(number); }));
    worst_.emplace("layers_in_window", Worst(
                                           [scene](double burn_rate) {
                                               return layers_in_window(
                                                   scene, with_largest_diffusivity(scene),
                                                   burn_rate);
                                           },
                                           Worst::Is::least));
}

/// A layer is D/r_b thick, or as thick as it has grown: after t, exp(-5) of the rise is left where
/// erfc(y/(2 sqrt(D t))) is, at 3.84 sqrt(D t).
double Watch::slowest_move(const State& state, double burn_rate) const {
    constexpr double depth_of_growth = 3.84, layers = 5.0;
    return std::max(burn_rate, layers / depth_of_growth * std::sqrt(diffusivity_ / state.time));
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
    meet("fourier", simulation.state().length);
    meet("front_coupling", largest_front_coupling(simulation, summary));
    meet("layers_in_window", slowest_move(simulation.state(), summary.mean_burn_rate));
    meet("alternation", turning(summary.mean_burn_rate));
    const State& state = simulation.state();
    const Crossed cells = crossing_.of(surface_, state);
    surface_ = state.surface;
    meet("crossing_y", cells.rows);
    meet("crossing_x", cells.columns);
    meet("front_crossing", cells.by_front);
    meet("slope", largest_slope(simulation.grid(), state.surface));
    return told;
}

Guards Watch::met() const {
    Guards met;
    for (const auto& [name, worst] : worst_)
        if (worst.is_met()) met.push_back(worst.guard());
    return met;
}

}  // namespace crawford
