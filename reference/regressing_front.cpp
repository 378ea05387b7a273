#include "reference/regressing_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "reference/require.hpp"
#include "reference/root.hpp"

namespace crawford::reference {

namespace {

void require_before(double t, double limit, std::string_view event) {
    require_not_negative("time", t);
    if (t >= limit)
        throw std::invalid_argument(
            fmt::format("time = {} must be before {} at {} s", t, event, limit));
}

}  // namespace

RegressingWave::RegressingWave(double amplitude, double period, double burn_rate)
    : amplitude_(amplitude), wave_number_(2.0 * std::numbers::pi / period), burn_rate_(burn_rate) {
    require_not_negative("amplitude", amplitude);
    require_positive("period", period);
    require_positive("burn rate", burn_rate);
}

double RegressingWave::start(double x) const {
    return amplitude_ * std::cos(wave_number_ * x);
}

double RegressingWave::start_slope(double x) const {
    return -amplitude_ * wave_number_ * std::sin(wave_number_ * x);
}

double RegressingWave::kink_time() const {
    if (amplitude_ == 0.0) return std::numeric_limits<double>::infinity();
    return 1.0 / (burn_rate_ * amplitude_ * wave_number_ * wave_number_);
}

double RegressingWave::foot(double x, double t) const {
    require_before(t, kink_time(), "the kink");
    const double reach = burn_rate_ * t;
    if (x - reach == x + reach) return x;
    const auto miss = [&](double x0) {
        const double p = start_slope(x0);
        return x0 + reach * p / std::hypot(1.0, p) - x;
    };
    return bracketed_root(miss, x - reach, x + reach);
}

double RegressingWave::height(double x, double t) const {
    const double x0 = foot(x, t);
    return start(x0) - burn_rate_ * t / std::hypot(1.0, start_slope(x0));
}

double RegressingWave::slope(double x, double t) const {
    return start_slope(foot(x, t));
}

double RegressingWave::envelope(double x, double t) const {
    require_not_negative("time", t);
    const double reach = burn_rate_ * t;
    // y = x + reach sin(a): the circle about (y, start(y)) is reach cos(a) below it at x.
    const auto circle = [&](double a) {
        return start(x + reach * std::sin(a)) - reach * std::cos(a);
    };
    // A point more than half a period away has a twin that is nearer, and whose circle is lower here.
    // Minima lie at least a fraction of the period apart: look for each between samples.
    constexpr int samples = 128;
    const double half_period = std::numbers::pi / wave_number_;
    const double widest = std::asin(std::min(1.0, half_period / reach));
    const double step = 2.0 * widest / samples;
    double lowest = circle(0.0);
    for (int k = 0; k <= samples; ++k) {
        const double a = k * step - widest;
        const double middle = circle(a);
        if (middle > circle(a - step) || middle > circle(a + step)) continue;
        const auto found = boost::math::tools::brent_find_minima(circle, a - step, a + step, 52);
        lowest = std::min(lowest, found.second);
    }
    return lowest;
}

RegressingZigzag::RegressingZigzag(double right, double left, double period, double burn_rate)
    : right_(right), left_(left), period_(period), burn_rate_(burn_rate) {
    require_positive("slope to the right", right);
    require_positive("slope to the left", left);
    require_positive("period", period);
    require_positive("burn rate", burn_rate);
}

/// The front that starts as max(right x, -left x).
double RegressingZigzag::valley(double x, double t) const {
    const double distance = std::abs(x);
    const double slope = x > 0.0 ? right_ : left_;
    const double radius = burn_rate_ * t;
    const double along = std::hypot(1.0, slope);
    if (distance < radius * slope / along)
        return -std::sqrt((radius - distance) * (radius + distance));
    return slope * distance - radius * along;
}

double RegressingZigzag::height(double x, double t) const {
    require_not_negative("time", t);
    const double from_left = x - period_ * std::floor(x / period_);
    return std::min(valley(from_left, t), valley(from_left - period_, t));
}

}  // namespace crawford::reference
