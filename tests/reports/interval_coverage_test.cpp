/// Tallies of intervals whose truth is known, on series made up for it.
#include "reports/interval_coverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace crawford::reports {
namespace {

using testing::HasSubstr;

/// 1 + h^p on five grids, whose truth is 1.
KnownSeries power(const std::string& problem, double p) {
    KnownSeries series{.problem = problem, .name = problem, .truth = 1.0};
    for (const double h : {0.5, 0.25, 0.125, 0.1, 0.05}) {
        series.h.push_back(h);
        series.values.push_back(1.0 + std::pow(h, p));
    }
    return series;
}

Estimator so_wide(double half_width) {
    return [=](const GridValues&, double) { return Estimate{.uncertainty = half_width}; };
}

/// As wide as the true error of the finest grid, times `factor`.
Estimator of_error(double factor) {
    return [=](const GridValues& grids, double) {
        return Estimate{.uncertainty = factor * std::abs(grids.values.back() - 1.0)};
    };
}

TEST(IntervalCoverage, CountsEverySet) {
    const std::vector<KnownSeries> all{power("a", 2.0), power("b", 1.0)};
    const auto three = coverage_of(so_wide(10.0), all, 3);
    EXPECT_EQ(three.sets, 20U);
    EXPECT_EQ(three.held, 20U);
    EXPECT_EQ(three.finest_held, 2U);
    EXPECT_EQ(three.coverage, 1.0);
    EXPECT_EQ(coverage_of(so_wide(10.0), all, 4).sets, 10U);
    EXPECT_EQ(coverage_of(so_wide(0.0), all, 3).coverage, 0.0);
    EXPECT_THROW(coverage_of(so_wide(1.0), all, 6), std::invalid_argument);
}

TEST(IntervalCoverage, MeasuresWidthsInTrueErrors) {
    const auto tally = coverage_of(of_error(1.7), {power("a", 2.0)}, 3);
    EXPECT_NEAR(tally.median_width, 1.7, 1e-12);
    EXPECT_NEAR(tally.upper_width, 1.7, 1e-12);
    EXPECT_EQ(coverage_of(of_error(0.99), {power("a", 2.0)}, 3).held, 0U);
}

TEST(IntervalCoverage, HoldsNothingWhereNothingIsSaid) {
    const auto tally = coverage_of(so_wide(Estimate::none), {power("a", 2.0)}, 3);
    EXPECT_EQ(tally.answered, 0U);
    EXPECT_EQ(tally.coverage, 0.0);
    for (const auto& [factor, weight] : factors_of(so_wide(Estimate::none), {power("a", 2.0)}, 3))
        EXPECT_TRUE(std::isinf(factor));
}

TEST(IntervalCoverage, LetsEachQuantityCountAlike) {
    KnownSeries few = power("b", 1.0);
    few.h.resize(3);
    few.values.resize(3);
    // Of the ten sets of "a" none is held, of "b" its only one.
    const Estimator only_b = [](const GridValues& grids, double) {
        return Estimate{.uncertainty = grids.values.back() > 1.1 ? 1.0 : 0.0};
    };
    const auto tally = coverage_of(only_b, {power("a", 4.0), few}, 3);
    EXPECT_EQ(tally.sets, 11U);
    EXPECT_EQ(tally.coverage, 0.5);
    EXPECT_EQ(tally.resampled.low, 0.0);
    EXPECT_EQ(tally.resampled.high, 1.0);
}

TEST(IntervalCoverage, TellsShapesOfSets) {
    const auto shape_of = [](const std::vector<double>& values) {
        const KnownSeries series{.h = {0.4, 0.2, 0.1}, .values = values};
        return coverage_of(so_wide(1.0), {series}, 3).shapes.begin()->first;
    };
    EXPECT_EQ(shape_of({1.16, 1.04, 1.01}), SetShape::regular);
    EXPECT_EQ(shape_of({1.4, 1.2, 1.1}), SetShape::irregular);
    EXPECT_EQ(shape_of({1.4, 1.0, 1.1}), SetShape::oscillating);
    EXPECT_EQ(shape_of({1.0, 1.1, 1.4}), SetShape::diverging);
}

TEST(IntervalCoverage, HasClopperAndPearsonsInterval) {
    // Their table: 0 of 10 and 5 of 10 at 95 %.
    EXPECT_NEAR(binomial_interval(0, 10).high, 0.3085, 5e-5);
    EXPECT_EQ(binomial_interval(0, 10).low, 0.0);
    EXPECT_NEAR(binomial_interval(5, 10).low, 0.1871, 5e-5);
    EXPECT_NEAR(binomial_interval(5, 10).high, 0.8129, 5e-5);
}

TEST(IntervalCoverage, LeavesOutWhatIsExact) {
    EXPECT_EQ(left_out(power("a", 2.0)), "");
    KnownSeries exact = power("a", 2.0);
    exact.values[2] = 1.0 + 1e-14;
    EXPECT_THAT(left_out(exact), HasSubstr("round-off"));
    exact.values[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(left_out(exact), HasSubstr("no number"));
}

}  // namespace
}  // namespace crawford::reports
