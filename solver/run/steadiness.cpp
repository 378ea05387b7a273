#include "solver/run/steadiness.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

namespace {

constexpr double window_length = 1e-3;  // [s]

double largest_diffusivity(const std::vector<Material>& materials) {
    double largest = 0.0;
    for (const Material& m : materials)
        largest = std::max(largest, m.thermal_conductivity / (m.density * m.specific_heat));
    return largest;
}

}  // namespace

Steadiness::Steadiness(const Scene& scene)
    : physics_(scene.physics),
      tolerance_(scene.time.until_steady),
      step_(scene.time.step),
      diffusivity_(largest_diffusivity(scene.morphology.materials)) {}

double Steadiness::watched(const Summary& summary) const {
    if (physics_.regression == Regression::pyrolysis) return summary.mean_burn_rate;
    return physics_.heat ? summary.largest_temperature : summary.largest_strain;
}

bool Steadiness::started(const State& state, const Summary& summary) const {
    if (!physics_.heat || physics_.regression == Regression::none) return true;
    const double burnt = -*std::ranges::max_element(state.surface);
    return burnt * summary.mean_burn_rate >= diffusivity_;
}

bool Steadiness::at_rest() const {
    // Half a step of grace: times are sums of steps.
    const double covered = window_.back().time - window_.front().time;
    if (covered < window_length - 0.5 * step_) return false;
    const auto [low, high] = std::ranges::minmax_element(window_, {}, &Sample::value);
    const double change = high->value - low->value;
    return change <= *tolerance_ * 0.5 * std::abs(high->value + low->value);
}

void Steadiness::record(const State& state, const Summary& summary) {
    if (!tolerance_) return;
    window_.push_back({state.time, watched(summary)});
    while (window_.front().time < state.time - window_length - 0.5 * step_) window_.pop_front();
    reached_ = at_rest() && started(state, summary);
}

}  // namespace crawford
