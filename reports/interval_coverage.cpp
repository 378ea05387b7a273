#include "reports/interval_coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "reports/extrapolate.hpp"

namespace crawford::reports {
namespace {

/// What becomes of one set.
struct Outcome {
    SetShape shape;
    double half_width;  ///< NaN where nothing is said
    double error;       ///< true, of the finest grid
    double size;        ///< of the value

    bool answers() const { return std::isfinite(half_width); }
    bool holds() const { return answers() && error <= half_width; }
};

/// The outcomes of one quantity; that of the finest grids is the last.
using Outcomes = std::vector<Outcome>;

SetShape shape_of(const std::vector<double>& h, const std::vector<double>& u, double formal) {
    const std::size_t n = u.size();
    if ((u[n - 3] - u[n - 2]) * (u[n - 2] - u[n - 1]) < 0.0) return SetShape::oscillating;
    const double p = observed_order(std::span<const double, 3>(h.data() + n - 3, 3),
                                    std::span<const double, 3>(u.data() + n - 3, 3));
    if (!(p > 0.0)) return SetShape::diverging;
    return std::abs(p - formal) <= 0.1 * formal ? SetShape::regular : SetShape::irregular;
}

Outcome outcome_of(const Estimator& estimator, const KnownSeries& series,
                   const std::vector<std::size_t>& chosen) {
    std::vector<double> h, u;
    for (const std::size_t k : chosen) {
        h.push_back(series.h[k]);
        u.push_back(series.values[k]);
    }
    return {.shape = shape_of(h, u, series.order),
            .half_width = estimator({h, u}, series.order).uncertainty,
            .error = std::abs(u.back() - series.truth),
            .size = std::abs(u.back())};
}

Outcomes outcomes_of(const Estimator& estimator, const KnownSeries& series, std::size_t size) {
    Outcomes all;
    std::vector<bool> is_chosen(series.h.size(), false);
    if (series.h.size() < size) return all;
    std::fill_n(is_chosen.begin(), size, true);
    do {
        std::vector<std::size_t> chosen;
        for (std::size_t k = 0; k < is_chosen.size(); ++k)
            if (is_chosen[k]) chosen.push_back(k);
        all.push_back(outcome_of(estimator, series, chosen));
    } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
    return all;
}

double share_held(const Outcomes& outcomes) {
    return double(std::ranges::count(outcomes, true, &Outcome::holds)) / double(outcomes.size());
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return Estimate::none;
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

/// Shares held of the quantities of each problem.
using Shares = std::map<std::string, std::vector<double>>;

double mean_of(const std::vector<const std::vector<double>*>& problems) {
    double sum = 0.0, count = 0.0;
    for (const auto* shares : problems)
        for (const double share : *shares) {
            sum += share;
            ++count;
        }
    return sum / count;
}

Range resampled(const Shares& shares) {
    constexpr int times = 2000;
    std::vector<const std::vector<double>*> problems;
    for (const auto& [problem, of] : shares) problems.push_back(&of);
    std::mt19937_64 random(1);  // the same for all: what differs is the estimates
    std::vector<double> means;
    for (int k = 0; k < times; ++k) {
        std::vector<const std::vector<double>*> drawn;
        for (std::size_t i = 0; i < problems.size(); ++i)
            drawn.push_back(problems[random() % problems.size()]);
        means.push_back(mean_of(drawn));
    }
    return {quantile(means, 0.025), quantile(means, 0.975)};
}

void count(const Outcomes& outcomes, CoverageTally& tally) {
    for (const Outcome& outcome : outcomes) {
        ShapeTally& shape = tally.shapes[outcome.shape];
        ++tally.sets, ++shape.sets;
        if (outcome.answers()) ++tally.answered, ++shape.answered;
        if (outcome.holds()) ++tally.held, ++shape.held;
    }
}

}  // namespace

std::string name(SetShape shape) {
    switch (shape) {
        case SetShape::regular:
            return "regular";
        case SetShape::irregular:
            return "irregular";
        case SetShape::oscillating:
            return "oscillating";
        default:
            return "diverging";
    }
}

std::string left_out(const KnownSeries& series) {
    // Hundred times what counts as round-off of an error (order.hpp): here differences are read.
    constexpr double small = 1e-10;
    double size = std::abs(series.truth);
    for (const double value : series.values) size = std::max(size, std::abs(value));
    for (const double value : series.values) {
        if (!std::isfinite(value)) return "a value is no number";
        if (std::abs(value - series.truth) <= small * size) return "exact to round-off on a grid";
    }
    return {};
}

Range binomial_interval(std::size_t held, std::size_t of) {
    using Binomial = boost::math::binomial_distribution<double>;
    constexpr double each_side = 0.025;
    return {Binomial::find_lower_bound_on_p(double(of), double(held), each_side),
            Binomial::find_upper_bound_on_p(double(of), double(held), each_side)};
}

CoverageTally coverage_of(const Estimator& estimator, const std::vector<KnownSeries>& all,
                          std::size_t size) {
    CoverageTally tally;
    Shares shares;
    std::vector<double> widths, relative;
    double sum = 0.0;
    for (const KnownSeries& series : all) {
        const Outcomes outcomes = outcomes_of(estimator, series, size);
        if (outcomes.empty()) continue;
        ++tally.quantities;
        count(outcomes, tally);
        const double share = share_held(outcomes);
        shares[series.problem].push_back(share);
        sum += share;
        if (outcomes.back().holds()) ++tally.finest_held;
        for (const Outcome& outcome : outcomes)
            if (outcome.answers()) {
                widths.push_back(outcome.half_width / outcome.error);
                relative.push_back(outcome.half_width / outcome.size);
            }
    }
    if (tally.sets == 0)
        throw std::invalid_argument(fmt::format("coverage_of: no set of {} grids", size));
    tally.problems = shares.size();
    tally.coverage = sum / double(tally.quantities);
    tally.resampled = resampled(shares);
    tally.binomial = binomial_interval(tally.finest_held, tally.quantities);
    tally.median_width = quantile(widths, 0.5);
    tally.upper_width = quantile(widths, 0.9);
    tally.median_relative = quantile(relative, 0.5);
    return tally;
}

std::vector<WeightedFactor> factors_of(const Estimator& estimator,
                                       const std::vector<KnownSeries>& all, std::size_t size) {
    std::vector<WeightedFactor> factors;
    for (const KnownSeries& series : all) {
        const Outcomes outcomes = outcomes_of(estimator, series, size);
        for (const Outcome& o : outcomes)
            factors.push_back(
                {o.answers() ? o.error / o.half_width : std::numeric_limits<double>::infinity(),
                 1.0 / double(outcomes.size())});
    }
    return factors;
}

}  // namespace crawford::reports
