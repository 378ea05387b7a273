#include "reports/extrapolate.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace crawford::reports {
namespace {

constexpr double lowest_order = 0.5;
constexpr double highest_order = 12.0;  // beyond any scheme; only bounds the search

/// log of (h1^p - h2^p)/(h2^p - h3^p), which rises with p; its limit stands in at p = 0.
double log_difference_ratio(double p, double log_coarse, double log_fine) {
    if (std::abs(p) < 1e-8) return std::log(log_coarse / log_fine);
    return p * log_fine + std::log(std::expm1(p * log_coarse) / std::expm1(p * log_fine));
}

}  // namespace

double observed_order(std::span<const double, 3> h, std::span<const double, 3> u) {
    const double ratio = std::log(std::abs(u[0] - u[1]) / std::abs(u[1] - u[2]));
    if (std::isnan(ratio)) return ratio;
    const double log_coarse = std::log(h[0] / h[1]), log_fine = std::log(h[1] / h[2]);
    const auto residual = [&](double p) {
        return log_difference_ratio(p, log_coarse, log_fine) - ratio;
    };
    // Where two of the values are the same the ratio is infinite, and the order as far as it goes.
    if (!std::isfinite(log_difference_ratio(-highest_order, log_coarse, log_fine)) ||
        !std::isfinite(log_difference_ratio(highest_order, log_coarse, log_fine)))
        return std::numeric_limits<double>::quiet_NaN();  // sizes too far apart for their powers
    if (residual(-highest_order) >= 0.0) return -highest_order;
    if (residual(highest_order) <= 0.0) return highest_order;
    std::uintmax_t iterations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        residual, -highest_order, highest_order, boost::math::tools::eps_tolerance<double>(48),
        iterations);
    return 0.5 * (low + high);
}

Extrapolation extrapolate(std::span<const double> h, std::span<const double> values,
                          double formal_order) {
    if (h.size() != values.size() || h.size() < 3)
        throw std::invalid_argument("extrapolate: needs three grids, with one value each");
    const std::size_t n = h.size();
    const std::array<double, 3> sizes{h[n - 3], h[n - 2], h[n - 1]},
        u{values[n - 3], values[n - 2], values[n - 1]};
    if (!(sizes[0] > sizes[1] && sizes[1] > sizes[2] && sizes[2] > 0.0))
        throw std::invalid_argument("extrapolate: the cell size must fall from grid to grid");

    Extrapolation limit{};
    limit.observed = observed_order(sizes, u);
    if (std::isnan(limit.observed)) {
        limit.value = limit.uncertainty = limit.order = limit.safety =
            std::numeric_limits<double>::quiet_NaN();
        return limit;
    }
    limit.order = std::clamp(limit.observed, lowest_order, std::max(lowest_order, formal_order));
    limit.safety = std::abs(limit.observed - formal_order) <= 0.1 * formal_order ? 1.25 : 3.0;
    const bool swings = (u[0] - u[1]) * (u[1] - u[2]) < 0.0;
    if (swings) limit.safety = 3.0;
    const double gain = std::pow(sizes[1] / sizes[2], limit.order) - 1.0;
    limit.value = u[2] + (u[2] - u[1]) / gain;
    limit.uncertainty = limit.safety * std::abs(u[2] - u[1]) / gain;
    return limit;
}

}  // namespace crawford::reports
