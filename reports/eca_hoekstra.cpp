/// The least-squares procedure of Eca and Hoekstra (2014), their section numbers in brackets.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>

#include "reports/estimate.hpp"

namespace crawford::reports {
namespace {

/// phi = phi_0 + sum alpha_k h^p_k, with the standard deviation of what it misses.
struct Fit {
    double order, limit, finest, deviation;
    std::string words;
};

/// Cell sizes relative to the finest, values, and weights that add up to one.
struct Samples {
    Eigen::VectorXd h, values, weights;
};

Samples samples(const GridValues& grids, bool by_size) {
    const auto n = static_cast<Eigen::Index>(grids.h.size());
    Samples s{Eigen::Map<const Eigen::VectorXd>(grids.h.data(), n),
              Eigen::Map<const Eigen::VectorXd>(grids.values.data(), n), Eigen::VectorXd::Ones(n)};
    s.h /= s.h(n - 1);
    if (by_size) s.weights = s.h.cwiseInverse();
    s.weights /= s.weights.sum();
    return s;
}

/// Least squares over phi_0 and the coefficients. `unknowns` counts the order, where it is one.
Fit fitted(const Samples& s, const std::vector<double>& powers, Eigen::Index unknowns) {
    const Eigen::Index n = s.h.size();
    Eigen::MatrixXd basis = Eigen::MatrixXd::Ones(n, 1 + static_cast<Eigen::Index>(powers.size()));
    for (std::size_t k = 0; k < powers.size(); ++k)
        basis.col(1 + static_cast<Eigen::Index>(k)) = s.h.array().pow(powers[k]);
    const Eigen::VectorXd root = s.weights.cwiseSqrt();
    const Eigen::VectorXd alpha =
        (root.asDiagonal() * basis).colPivHouseholderQr().solve(root.cwiseProduct(s.values));
    const Eigen::VectorXd rest = s.values - basis * alpha;
    const double squares = static_cast<double>(n) * s.weights.dot(rest.cwiseAbs2());
    return {.order = powers.front(),
            .limit = alpha(0),
            .finest = basis.row(n - 1).dot(alpha),
            .deviation = std::sqrt(squares / static_cast<double>(n - unknowns)),
            .words = {}};
}

/// The order that fits best, between 0 and 10.
Fit fitted_with_order(const Samples& s) {
    const auto miss = [&](double p) { return fitted(s, {p}, 3).deviation; };
    constexpr double lowest = 0.01, highest = 10.0, step = 0.05;
    double best = lowest;
    for (int k = 0; k * step <= highest - lowest; ++k)
        if (const double p = lowest + k * step; miss(p) < miss(best)) best = p;
    const auto [p, least] =
        boost::math::tools::brent_find_minima(miss, std::max(lowest, best - step), best + step, 30);
    return fitted(s, {p}, 3);
}

const Fit& better(const Fit& a, const Fit& b) {
    return b.deviation < a.deviation ? b : a;
}

/// The better of the fits with and without weights.
Fit with_either_weights(const GridValues& grids, const std::string& words,
                        const std::function<Fit(const Samples&)>& fit) {
    Fit chosen = better(fit(samples(grids, false)), fit(samples(grids, true)));
    chosen.words = words;
    return chosen;
}

Fit with_power(const GridValues& grids, double p) {
    return with_either_weights(grids, fmt::format("fit of fixed order {:g}", p),
                               [&](const Samples& s) { return fitted(s, {p}, 2); });
}

/// The fit that the error is read from: of free order where that lies within [0.5, 2], else of the
/// fixed orders 1 or 2, below 0.5 also of both together.
Fit chosen_fit(const GridValues& grids) {
    Fit chosen = with_either_weights(grids, "fit of free order", fitted_with_order);
    if (chosen.order >= 0.5 && chosen.order <= 2.0) return chosen;
    Fit fixed = better(with_power(grids, 1.0), with_power(grids, 2.0));
    if (chosen.order > 2.0) return fixed;
    return better(
        fixed, with_either_weights(grids, "fit of orders 1 and 2 together", [](const Samples& s) {
            return fitted(s, {1.0, 2.0}, 3);
        }));
}

}  // namespace

Estimate eca_hoekstra_2014(const GridValues& grids) {
    Estimate estimate{.name = "eca-hoekstra-2014"};
    const std::size_t n = grids.h.size();
    if (n < 4) {
        estimate.note = fmt::format("needs four grids, not {}", n);
        return estimate;
    }
    const auto [low, high] = std::ranges::minmax(grids.values);
    const double range = (high - low) / static_cast<double>(n - 1);
    if (!(range > 0.0)) {
        estimate.note = "all grids have the same value";
        return estimate;
    }
    const Fit fit = chosen_fit(grids);
    const double error = std::abs(fit.finest - fit.limit);
    const double rest = fit.deviation + std::abs(grids.values.back() - fit.finest);
    const bool is_smooth = fit.deviation < range;
    estimate.order = fit.order;
    estimate.extrapolated = fit.limit;
    estimate.safety = is_smooth && fit.order >= 0.5 && fit.order < 2.1 ? 1.25 : 3.0;
    estimate.uncertainty =
        is_smooth ? estimate.safety * error + rest : 3.0 * fit.deviation / range * (error + rest);
    if (grids.values.back() != 0.0)
        estimate.relative_uncertainty = estimate.uncertainty / std::abs(grids.values.back());
    estimate.note = fit.words + (is_smooth ? "" : "; the values scatter");
    return estimate;
}

}  // namespace crawford::reports
