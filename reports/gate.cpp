#include "reports/gate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/default_estimate.hpp"

namespace crawford::reports {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string missing_grids(const Convergence& convergence, const std::vector<int>& wanted) {
    std::vector<int> missing;
    for (int grid : wanted)
        if (std::ranges::find(convergence.levels(), grid, &Level::grid) ==
            convergence.levels().end())
            missing.push_back(grid);
    return missing.empty() ? "" : fmt::format("no error from grid {}", fmt::join(missing, ", "));
}

std::string out_of_tolerance(double fit, const Expectation& expected) {
    if (fit >= expected.order - expected.below && fit <= expected.order + expected.above) return "";
    return fmt::format("order {:.3f} is outside [{:.3g}, {:.3g}]", fit,
                       expected.order - expected.below, expected.order + expected.above);
}

std::string not_a_number(const Convergence& convergence) {
    for (const auto& level : convergence.levels())
        if (!std::isfinite(level.error))
            return fmt::format("grid {}: error is {}", level.grid, level.error);
    return "";
}

void record(GateResult& result, const Convergence& all, const Convergence& range,
            double formal_order) {
    for (const auto& level : all.levels()) {
        result.grids.push_back(level.grid);
        result.h.push_back(level.h);
        result.errors.push_back(level.error);
    }
    result.pairwise = all.pairwise();
    result.scale = all.scale();
    result.fit = range.fit();
    std::vector<double> h, errors;
    for (const auto& level : range.levels()) {
        h.push_back(level.h);
        errors.push_back(level.error);
    }
    if (h.size() >= 3 && !range.defect()) result.limit = default_limit(h, errors, formal_order);
}

}  // namespace

Expectation expect(double order) {
    Expectation expected{};
    expected.order = order;
    return expected;
}

Expectation Expectation::within(double less, double more) const {
    auto copy = *this;
    copy.below = less;
    copy.above = more;
    return copy;
}

Expectation Expectation::or_better(double less) const {
    return within(less, infinity);
}

Expectation Expectation::from(int coarsest_grid) const {
    auto copy = *this;
    copy.coarsest = coarsest_grid;
    return copy;
}

Expectation Expectation::to(int finest_grid) const {
    auto copy = *this;
    copy.finest = finest_grid;
    return copy;
}

Expectation Expectation::scattering(double limit) const {
    auto copy = *this;
    copy.scatter = limit;
    return copy;
}

Expectation Expectation::of_size(double truth) const {
    auto copy = *this;
    copy.scale = truth;
    return copy;
}

Interval between(double low, double high) {
    return {low, high};
}
Interval at_most(double high) {
    return {-infinity, high};
}
Interval at_least(double low) {
    return {low, infinity};
}

std::string short_of(const Expectation& expected, Verdict verdict, double fit) {
    if (verdict == Verdict::not_asymptotic)
        return fmt::format(
            "not asymptotic: a pairwise order lies further than {:.3g} from the fit {:.3f}",
            expected.scatter, fit);
    if (verdict != Verdict::monotone) return fmt::format("errors are {}", name(verdict));
    return out_of_tolerance(fit, expected);
}

GateResult judge(const Gate& gate, const Convergence& convergence, const std::vector<int>& wanted,
                 const std::vector<int>& left_out) {
    GateResult result;
    result.quantity = gate.quantity;
    result.norm = name(gate.norm);
    result.reason = gate.reason;
    result.expected = gate.expected.order;
    result.below = gate.expected.below;
    result.above = gate.expected.above;
    auto needed = wanted;
    auto extent = wanted;  // of the fit, where the gate does not say
    extent.insert(extent.end(), left_out.begin(), left_out.end());
    for (const auto& named : {gate.expected.coarsest, gate.expected.finest}) {
        if (!named) continue;
        extent.push_back(*named);
        if (left_out.empty()) needed.push_back(*named);
    }
    if (!extent.empty()) {
        const auto [low, high] = std::ranges::minmax(extent);
        result.coarsest = gate.expected.coarsest.value_or(low);
        result.finest = gate.expected.finest.value_or(high);
    }

    const auto range = convergence.between(result.coarsest, result.finest);
    record(result, convergence, range, gate.expected.order);
    const auto defect = range.defect();
    const auto verdict = defect ? Verdict::diverging : range.verdict(gate.expected.scatter);
    result.verdict = defect ? "none" : name(verdict);

    // The first reason not to pass, in the order in which a reader should hear of them.
    if (gate.reason.empty()) result.failure = "the gate gives no reason for its bound";
    if (result.failure.empty()) result.failure = missing_grids(convergence, needed);
    if (result.failure.empty()) result.failure = not_a_number(convergence);
    if (result.failure.empty() && !left_out.empty()) {
        leave_ungated(result, left_out);
        return result;
    }
    if (result.failure.empty())
        result.failure = defect ? *defect : short_of(gate.expected, verdict, result.fit);
    result.passed = result.failure.empty();
    return result;
}

void leave_ungated(GateResult& result, const std::vector<int>& left_out) {
    result.gated = result.passed = false;
    result.verdict = "too few grids to gate";
    result.failure = fmt::format("too few grids to gate: {} not run", fmt::join(left_out, ", "));
}

GateResult judge(const Bound& bound, double value) {
    GateResult result;
    result.kind = GateKind::bound;
    result.quantity = bound.quantity;
    result.reason = bound.reason;
    result.value = value;
    result.low = bound.allowed.low;
    result.high = bound.allowed.high;
    const bool inside = value >= result.low && value <= result.high;
    if (bound.reason.empty())
        result.failure = "the bound gives no reason";
    else if (!std::isfinite(value))
        result.failure = fmt::format("value is {}", value);
    else if (!inside)
        result.failure =
            fmt::format("{:.6g} is outside [{:.6g}, {:.6g}]", value, result.low, result.high);
    result.passed = result.failure.empty();
    result.verdict = std::isnan(value) ? "none" : inside ? "within bounds" : "out of bounds";
    return result;
}

}  // namespace crawford::reports
