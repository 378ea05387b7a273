#include "solver/run/steadiness.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

namespace {

constexpr double least_window = 1e-3;  // [s]

// Of the relaxation time 4 D/r_b^2, the part over which a change is looked for: what is left to go
// is then at most a hundred times that change.
constexpr double share_of_relaxation = 0.01;

}  // namespace

Steadiness::Steadiness(const Scene& scene)
    : physics_(scene.physics),
      tolerance_(scene.time.until_steady),
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

/// How long a rate must not have changed [s]: a slow burn changes slowly.
double Steadiness::window_length(const Summary& summary) const {
    if (!physics_.heat || summary.mean_burn_rate <= 0.0) return least_window;
    const double layer = 4.0 * diffusivity_ / (summary.mean_burn_rate * summary.mean_burn_rate);
    return std::max(least_window, share_of_relaxation * layer);
}

bool Steadiness::at_rest(double length) const {
    if (!covers(window_.front(), length)) return false;
    const auto [low, high] = std::ranges::minmax_element(window_, {}, &Sample::value);
    const double change = high->value - low->value;
    return change <= *tolerance_ * 0.5 * std::abs(high->value + low->value);
}

/// Whether so long has passed since a sample.
bool Steadiness::covers(const Sample& sample, double length) const {
    constexpr double rounding = 1e-9;  // times are sums of steps
    return window_.back().time - sample.time >= length * (1.0 - rounding);
}

void Steadiness::record(const State& state, const Summary& summary) {
    if (!tolerance_) return;
    window_.push_back({state.time, watched(summary)});
    const double length = window_length(summary);
    // The oldest is the last that is far enough back: steps may have any lengths.
    while (window_.size() > 1 && covers(window_[1], length)) window_.pop_front();
    reached_ = at_rest(length) && started(state, summary);
}

}  // namespace crawford
