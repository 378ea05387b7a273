#include "reports/value_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "reports/default_estimate.hpp"

namespace crawford::reports {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// log of |h_i^p - h_i+1^p|/|p| and its slope in p, up to what is the same for all pairs of grids.
struct Growth {
    double value, slope;
};

Growth growth(double p, double h_coarse, double h_fine) {
    const double ratio = std::log(h_coarse / h_fine), x = p * ratio;
    const double log_fine = std::log(h_fine);
    if (std::abs(x) < 1e-6)  // the next terms of both series are below round-off
        return {p * log_fine + std::log(ratio) + 0.5 * x, log_fine + 0.5 * ratio};
    return {p * log_fine + std::log(std::expm1(x) / p),
            log_fine - ratio / std::expm1(-x) - 1.0 / p};
}

/// One Gauss-Newton step of the least-squares fit.
double correction(double p, const std::vector<ValueLevel>& levels,
                  const std::vector<double>& differences) {
    const auto n = static_cast<double>(differences.size());
    std::vector<double> rest, slope;
    double rest_mean = 0.0, slope_mean = 0.0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        const Growth g = growth(p, levels[i].h, levels[i + 1].h);
        rest.push_back(std::log(std::abs(differences[i])) - g.value);
        slope.push_back(g.slope);
        rest_mean += rest.back() / n;
        slope_mean += slope.back() / n;
    }
    double down = 0.0, across = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        across += (rest[i] - rest_mean) * (slope[i] - slope_mean);
        down += (slope[i] - slope_mean) * (slope[i] - slope_mean);
    }
    return across / down;
}

std::optional<std::string> defect_of(const ValueLevel& level) {
    if (!std::isfinite(level.value))
        return fmt::format("grid {}: value is {}", level.grid, level.value);
    if (!std::isfinite(level.h) || level.h <= 0.0)
        return fmt::format("grid {}: cell size is {}", level.grid, level.h);
    return {};
}

}  // namespace

ValueConvergence::ValueConvergence(std::vector<ValueLevel> levels) : levels_(std::move(levels)) {
    std::ranges::stable_sort(levels_, std::greater{}, &ValueLevel::h);
}

std::vector<double> ValueConvergence::h() const {
    std::vector<double> sizes;
    for (const auto& level : levels_) sizes.push_back(level.h);
    return sizes;
}

std::vector<double> ValueConvergence::values() const {
    std::vector<double> all;
    for (const auto& level : levels_) all.push_back(level.value);
    return all;
}

std::vector<double> ValueConvergence::differences() const {
    std::vector<double> all;
    for (std::size_t i = 1; i < levels_.size(); ++i)
        all.push_back(levels_[i - 1].value - levels_[i].value);
    return all;
}

std::vector<double> ValueConvergence::pairwise() const {
    const auto sizes = h(), all = values();
    std::vector<double> orders;
    for (std::size_t i = 2; i < all.size(); ++i)
        orders.push_back(observed_order(std::span<const double, 3>(sizes.data() + i - 2, 3),
                                        std::span<const double, 3>(all.data() + i - 2, 3)));
    return orders;
}

double ValueConvergence::fit() const {
    const auto orders = pairwise();
    const auto steps = differences();
    if (orders.empty() || std::ranges::count(steps, 0.0) > 0) return nan;
    if (orders.size() == 1) return orders.front();
    double p = orders.back();
    constexpr int most = 100;  // with one refinement ratio it takes one
    for (int k = 0; k < most; ++k) {
        const double step = correction(p, levels_, steps);
        p += step;
        if (!(std::abs(step) > 1e-13 * (1.0 + std::abs(p)))) return p;
    }
    return nan;
}

Verdict ValueConvergence::verdict(double scatter) const {
    const auto steps = differences();
    const double slope = fit();
    if (!(slope > 0.0)) return Verdict::diverging;
    for (std::size_t i = 1; i < steps.size(); ++i)
        if (steps[i] * steps[i - 1] < 0.0) return Verdict::oscillating;
    if (std::ranges::any_of(pairwise(),
                            [&](double p) { return !(std::abs(p - slope) <= scatter); }))
        return Verdict::not_asymptotic;
    return Verdict::monotone;
}

std::optional<std::string> ValueConvergence::defect() const {
    if (levels_.size() < 3)
        return fmt::format("{} of at least 3 grids to read an order from", levels_.size());
    double size = 0.0;
    for (const auto& level : levels_) {
        if (auto reason = defect_of(level)) return reason;
        size = std::max(size, std::abs(level.value));
    }
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        const auto &coarse = levels_[i - 1], &fine = levels_[i];
        if (coarse.h == fine.h)
            return fmt::format("grids {} and {} have the same cell size", coarse.grid, fine.grid);
        if (std::abs(coarse.value - fine.value) <= roundoff * size)
            return fmt::format("grids {} and {} have the same value to round-off", coarse.grid,
                               fine.grid);
    }
    return {};
}

GateResult judge(const Gate& gate, const ValueConvergence& convergence) {
    GateResult result;
    result.quantity = gate.quantity;
    result.norm = "value";
    result.reason = gate.reason;
    result.expected = gate.expected.order;
    result.below = gate.expected.below;
    result.above = gate.expected.above;
    std::vector<ValueLevel> within;
    for (const auto& level : convergence.levels()) {
        result.grids.push_back(level.grid);
        if (level.grid >= gate.expected.coarsest.value_or(level.grid) &&
            level.grid <= gate.expected.finest.value_or(level.grid))
            within.push_back(level);
    }
    result.h = convergence.h();
    result.values = convergence.values();
    result.pairwise = convergence.pairwise();
    if (!within.empty()) {
        result.coarsest = within.front().grid;
        result.finest = within.back().grid;
    }

    const ValueConvergence range(within);
    const auto defect = range.defect();
    const auto verdict = defect ? Verdict::diverging : range.verdict(gate.expected.scatter);
    result.verdict = defect ? "none" : name(verdict);
    result.fit = range.fit();
    if (!defect) result.limit = default_limit(range.h(), range.values(), gate.expected.order);
    result.failure = defect ? *defect : short_of(gate.expected, verdict, result.fit);
    result.passed = result.failure.empty();
    return result;
}

}  // namespace crawford::reports
