#include "solver/run/step_error.hpp"

#include <algorithm>
#include <cmath>

#include "solver/guards/steady_slab.hpp"
#include "solver/time_integration/time_step.hpp"

namespace crawford {

namespace {

/// The heated layer forgets what a step does to its temperature: where steps of the sandwich and of a
/// pack each add up to three times what is asked for, V is still off by less than that.
constexpr double forgotten = 3.0;

double median_size(std::vector<double> values) {
    for (double& v : values) v = std::abs(v);
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

StepError::StepError(const Scene& scene, const Grid& grid)
    : grid_(grid),
      end_(scene.time.end),
      order_(scene.time.scheme == Stepping::bdf2 ? 3 : 2),
      diffusivity_(largest_diffusivity(scene.morphology.materials)),
      activation_(largest_activation(scene)) {}

/// Of the temperature of each node of the surface.
std::vector<double> StepError::slopes(const State& before, const State& after) {
    std::vector<double> slopes;
    const NodeField& now = after.temperature;
    for (int i = 0; i < now.columns(); ++i)
        slopes.push_back((now(i, now.rows() - 1) - before.temperature(i, now.rows() - 1)) /
                         after.length);
    return slopes;
}

/// y''/2 as the second divided difference.
std::vector<double> StepError::curvatures(const std::vector<double>& slopes, double length) const {
    std::vector<double> curvatures(slopes.size());
    for (size_t k = 0; k < slopes.size(); ++k)
        curvatures[k] = (slopes[k] - memory_.slope[k]) / (length + memory_.length);
    return curvatures;
}

double StepError::span_of(double length) const {
    if (order_ == 2) return length;
    return bdf2_weights(length / memory_.length).of_span * length;
}

/// Of a quantity whose derivative of the order of the error, y'' or y''', is 1.
double StepError::missed(double length) const {
    if (order_ == 2) return 0.5 * length * length;
    return 4.0 / 6.0 * length * (length + memory_.length) * span_of(length);
}

/// y'' or y''' of each temperature.
std::vector<double> StepError::derivatives(const std::vector<double>& slopes, double length) const {
    std::vector<double> derivatives = curvatures(slopes, length);
    for (size_t k = 0; k < derivatives.size(); ++k)
        derivatives[k] = order_ == 2 ? 2.0 * derivatives[k]
                                     : 6.0 * (derivatives[k] - memory_.curvature[k]) /
                                           (length + memory_.length + memory_.length_before);
    return derivatives;
}

double StepError::of(const State& before, const State& after) const {
    if (memory_.slope.empty() || (order_ == 3 && memory_.curvature.empty())) return 0.0;
    const double dt = after.length;
    const std::vector<double> slope = slopes(before, after);
    const double hottest = *std::ranges::max_element(after.temperature.values());
    const double temperature = missed(dt) * median_size(derivatives(slope, dt)) / hottest;

    const double rate = std::max(memory_.fastest, mean_rate(before, after));
    const double layer = diffusivity_ / rate;
    const double matters =
        mean_rate(before, after) / std::max(rate, std::sqrt(diffusivity_ / after.time));
    const double sensitivity = activation_ / hottest;  // dr/r of dT/T
    const double burn_rate = sensitivity * temperature * matters;

    std::vector<double> turn = curvatures(slope, dt);
    for (double& t : turn) t *= 2.0;
    const double change = median_size(order_ == 2 ? slope : turn) / hottest;
    const double lasts = std::max(std::min(after.time, layer / rate) / dt, 1.0);
    const double height = missed(dt) * sensitivity * change * mean_rate(before, after) * lasts /
                          std::max(rate * end_, layer);
    return std::max(height, std::max(temperature, burn_rate) / forgotten);
}

double StepError::mean_rate(const State& before, const State& after) const {
    return std::abs(mean_height(grid_, after.surface) - mean_height(grid_, before.surface)) /
           after.length;
}

void StepError::accept(const State& before, const State& after) {
    std::vector<double> slope = slopes(before, after);
    if (!memory_.slope.empty()) memory_.curvature = curvatures(slope, after.length);
    memory_.fastest = std::max(memory_.fastest, mean_rate(before, after));
    memory_.slope = std::move(slope);
    memory_.length_before = memory_.length;
    memory_.length = after.length;
}

}  // namespace crawford
