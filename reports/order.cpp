#include "reports/order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace crawford::reports {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two errors closer than this, relative to their size, are one number computed twice.
constexpr double identical = 1e-10;

std::optional<std::string> defect_of(const Level& level, double scale) {
    if (!std::isfinite(level.error))
        return fmt::format("grid {}: error is {}", level.grid, level.error);
    if (level.error < 0.0) return fmt::format("grid {}: error is negative", level.grid);
    if (!std::isfinite(level.h) || level.h <= 0.0)
        return fmt::format("grid {}: cell size is {}", level.grid, level.h);
    if (level.error <= roundoff * scale)
        return fmt::format("grid {}: error {:.1e} is at round-off of {:.1e}", level.grid,
                           level.error, scale);
    return {};
}

bool all_alike(const std::vector<Level>& levels) {
    const auto [low, high] = std::ranges::minmax_element(levels, {}, &Level::error);
    return high->error - low->error <= identical * high->error;
}

}  // namespace

std::string_view name(Verdict verdict) {
    switch (verdict) {
        case Verdict::monotone:
            return "monotone";
        case Verdict::oscillating:
            return "oscillating";
        case Verdict::diverging:
            return "diverging";
        case Verdict::not_asymptotic:
            return "not asymptotic";
    }
    throw std::invalid_argument("no such verdict");
}

Convergence::Convergence(std::vector<Level> levels, double scale, std::size_t least)
    : levels_(std::move(levels)), scale_(scale), least_(least) {
    std::ranges::stable_sort(levels_, std::greater{}, &Level::h);
}

Convergence Convergence::between(int coarsest, int finest) const {
    auto kept = levels_;
    std::erase_if(kept, [&](const Level& l) { return l.grid < coarsest || l.grid > finest; });
    return Convergence(std::move(kept), scale_, least_);
}

std::vector<double> Convergence::pairwise() const {
    std::vector<double> orders;
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        const auto &coarse = levels_[i - 1], &fine = levels_[i];
        orders.push_back(std::log(coarse.error / fine.error) / std::log(coarse.h / fine.h));
    }
    return orders;
}

double slope_of_logarithms(std::span<const double> x, std::span<const double> y) {
    if (x.size() < 2) return nan;
    const auto n = static_cast<double>(x.size());
    double x_mean = 0.0, y_mean = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        x_mean += std::log(x[k]) / n;
        y_mean += std::log(y[k]) / n;
    }
    double xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double from_mean = std::log(x[k]) - x_mean;
        xx += from_mean * from_mean;
        xy += from_mean * (std::log(y[k]) - y_mean);
    }
    return xy / xx;
}

double Convergence::fit() const {
    std::vector<double> h, errors;
    for (const auto& level : levels_) {
        h.push_back(level.h);
        errors.push_back(level.error);
    }
    return slope_of_logarithms(h, errors);
}

Verdict Convergence::verdict(double scatter) const {
    const auto orders = pairwise();
    const double slope = fit();
    if (!(slope > 0.0) || !(levels_.back().error < levels_.front().error))
        return Verdict::diverging;
    if (std::ranges::any_of(orders, [](double p) { return !(p > 0.0); }))
        return Verdict::oscillating;
    if (std::ranges::any_of(orders, [&](double p) { return !(std::abs(p - slope) <= scatter); }))
        return Verdict::not_asymptotic;
    return Verdict::monotone;
}

std::optional<std::string> Convergence::defect() const {
    if (levels_.size() < least_)
        return fmt::format("{} of at least {} {} to read an order from", levels_.size(), least_,
                           least_ == 3 ? "grids" : "differences");
    if (!std::isfinite(scale_)) return fmt::format("size of the truth is {}", scale_);
    for (const auto& level : levels_)
        if (auto reason = defect_of(level, scale_)) return reason;
    for (std::size_t i = 1; i < levels_.size(); ++i)
        if (levels_[i].h == levels_[i - 1].h)
            return fmt::format("grids {} and {} have the same cell size", levels_[i - 1].grid,
                               levels_[i].grid);
    if (all_alike(levels_))
        return fmt::format("the same error {:.3e} on every grid", levels_[0].error);
    return {};
}

Convergence from_differences(std::vector<Level> levels, double scale) {
    Convergence convergence(std::move(levels), scale, 2);
    const auto& sorted = convergence.levels();
    for (std::size_t i = 2; i < sorted.size(); ++i) {
        const double first = sorted[0].h / sorted[1].h, here = sorted[i - 1].h / sorted[i].h;
        if (!(std::abs(here - first) <= 0.01 * first))
            throw std::invalid_argument(fmt::format(
                "successive differences need one refinement ratio, not {:.3g} and {:.3g}", first,
                here));
    }
    return convergence;
}

double self_referenced_order(double p) {
    return std::log2(std::exp2(p) + 1.0);
}

}  // namespace crawford::reports
