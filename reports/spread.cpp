#include "reports/spread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/errors.hpp"

namespace crawford::reports {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Half-width over standard deviation.
double reach(long count, double confidence) {
    const boost::math::students_t distribution(double(count - 1));
    return quantile(distribution, 0.5 + 0.5 * confidence) / std::sqrt(double(count));
}

void check(double confidence) {
    if (!(confidence > 0.0 && confidence < 1.0))
        throw InputError(
            fmt::format("a confidence of {} must lie between 0 and 1, as 0.95", confidence));
}

}  // namespace

Spread spread(const std::vector<double>& values, double confidence) {
    check(confidence);
    Spread found{long(values.size()), none, none, none};
    if (values.empty()) return found;
    const auto n = double(values.size());
    found.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    if (values.size() < 2) return found;
    double squares = 0.0;
    for (const double value : values) squares += (value - found.mean) * (value - found.mean);
    found.standard_deviation = std::sqrt(squares / (n - 1.0));
    found.half_width = found.standard_deviation * reach(found.count, confidence);
    return found;
}

std::optional<long> members_needed(const Spread& spread, double interval, double confidence) {
    check(confidence);
    const double allowed = interval * std::abs(spread.mean);
    if (!std::isfinite(spread.standard_deviation) || !(allowed > 0.0)) return {};
    // The normal distribution needs fewer, and Student's nears it: some ten at most are left.
    const double z = quantile(boost::math::normal(), 0.5 + 0.5 * confidence);
    const double least = std::pow(z * spread.standard_deviation / allowed, 2.0);
    constexpr double most = 1e9;  // beyond, the answer is that it cannot be had
    if (least > most) return {};
    long count = std::max(2L, long(least));
    while (spread.standard_deviation * reach(count, confidence) > allowed) ++count;
    return count;
}

}  // namespace crawford::reports
