#include "reports/order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "reports/extrapolate.hpp"

namespace crawford::reports {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Logarithms of numbers that carry relative round-off of 1e-16, divided by log 2.
constexpr double round_off = 1e-12;

Convergence errors(const std::function<double(double)>& of,
                   const std::vector<int>& grids = {32, 64, 128, 256}) {
    std::vector<Level> levels;
    for (const int n : grids) levels.push_back({n, 1.0 / n, of(1.0 / n)});
    return Convergence(levels);
}

Convergence listed(const std::vector<double>& values) {
    std::vector<Level> levels;
    int grid = 32;
    for (const double e : values) {
        levels.push_back({grid, 1.0 / grid, e});
        grid *= 2;
    }
    return Convergence(levels);
}

class KnownOrder : public testing::TestWithParam<double> {};

TEST_P(KnownOrder, IsReadFromEveryPairAndFromTheFit) {
    const double p = GetParam();
    for (const auto& grids : {std::vector{32, 64, 128, 256}, std::vector{20, 30, 70, 100}}) {
        const auto convergence = errors([&](double h) { return 7.0 * std::pow(h, p); }, grids);
        EXPECT_FALSE(convergence.defect());
        for (const double order : convergence.pairwise()) EXPECT_NEAR(order, p, round_off);
        EXPECT_NEAR(convergence.fit(), p, round_off);
        EXPECT_EQ(convergence.verdict(), Verdict::monotone);
    }
}

TEST_P(KnownOrder, IsReadFromSuccessiveDifferences) {
    const double p = GetParam();
    const auto solution = [&](double h) { return 5.0 - 3.0 * std::pow(h, p); };
    std::vector<Level> levels;
    for (const int n : {32, 64, 128})
        levels.push_back({n, 1.0 / n, std::abs(solution(1.0 / n) - solution(0.5 / n))});
    // Subtracting numbers of size 5 loses up to 5e-16 of differences as small as 3 * 128^-3 = 1e-6.
    for (const double order : from_differences(levels).pairwise()) EXPECT_NEAR(order, p, 1e-8);
    EXPECT_FALSE(from_differences(levels).defect());
}

TEST_P(KnownOrder, IsBiasedWhenTheFinestGridIsTheTruth) {
    const double p = GetParam();
    const auto solution = [&](double h) { return 1.0 + std::pow(h, p); };
    std::vector<Level> levels;
    for (const int n : {32, 64, 128})
        levels.push_back({n, 1.0 / n, std::abs(solution(1.0 / n) - solution(1.0 / 256))});
    EXPECT_NEAR(Convergence(levels).pairwise().back(), self_referenced_order(p), 1e-8);
    EXPECT_GT(self_referenced_order(p), p);
}

TEST_P(KnownOrder, ExtrapolatesAPowerToItsLimit) {
    const double p = GetParam();
    const std::vector<double> h{1.0 / 20, 1.0 / 30, 1.0 / 70};
    std::vector<double> u;
    for (const double size : h) u.push_back(300.0 + 40.0 * std::pow(size, p));
    const auto limit = extrapolate(h, u, p);
    // Round-off of 300, 6e-14, against differences of at least 1e-4.
    EXPECT_NEAR(limit.observed, p, 1e-7);
    EXPECT_NEAR(limit.value, 300.0, 1e-7);
    EXPECT_EQ(limit.safety, 1.25);
    EXPECT_NEAR(limit.uncertainty, 1.25 * (u[2] - 300.0), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Orders, KnownOrder, testing::Values(0.6, 1.0, 1.5, 2.0, 3.0));

TEST(SelfReference, ReadsTheOrdersThatTheClosedFormGives) {
    EXPECT_NEAR(self_referenced_order(1.0), std::log2(3.0), round_off);
    EXPECT_NEAR(self_referenced_order(2.0), std::log2(5.0), round_off);
    // Fitted over the three grids below the one taken for the truth, errors (512/n)^p - 1 with n =
    // 64, 128, 256. By hand for p = 1: 7, 3, 1, so (log2(7/3) + log2(3))/2 = 1.404. Likewise 1.000
    // and 2.196.
    for (const auto& [truth, seen] : {std::pair{0.38, 0.999}, {1.0, 1.404}, {2.0, 2.196}}) {
        const double p = truth;
        const auto fit =
            errors([&](double h) { return std::pow(512 * h, p) - 1.0; }, {64, 128, 256}).fit();
        EXPECT_NEAR(fit, seen, 0.0005) << p;
    }
}

TEST(Fit, RunsOverTheRangeAsked) {
    const auto bent = errors([](double h) { return h > 1.0 / 50 ? 1.0 : h * h; });
    EXPECT_NEAR(bent.between(64, 256).fit(), 2.0, round_off);
    EXPECT_EQ(bent.between(64, 256).levels().size(), 3U);
    EXPECT_GT(std::abs(bent.fit() - 2.0), 0.5);
}

TEST(Fit, SortsTheGrids) {
    const Convergence shuffled({{128, 1.0 / 128, 1.0}, {32, 1.0 / 32, 16.0}, {64, 1.0 / 64, 4.0}});
    EXPECT_EQ(shuffled.levels().front().grid, 32);
    EXPECT_NEAR(shuffled.fit(), 2.0, round_off);
}

TEST(VerdictOf, TellsTheShapesApart) {
    EXPECT_EQ(listed({16, 4, 1}).verdict(), Verdict::monotone);
    EXPECT_EQ(listed({16, 4, 5, 1}).verdict(), Verdict::oscillating);
    EXPECT_EQ(listed({1, 4, 16}).verdict(), Verdict::diverging);
    EXPECT_EQ(listed({16, 4, 20}).verdict(), Verdict::diverging);
    EXPECT_EQ(listed({16, 4, 2}).verdict(), Verdict::not_asymptotic) << "orders 2 and 1";
    EXPECT_EQ(listed({16, 4, 2}).verdict(0.6), Verdict::monotone)
        << "0.5 from the fit of 1.5, allowed";
}

// A second-order error that stalls at a floor of another model: 2.0, 1.9, 1.6. No averaging may
// hide that.
TEST(VerdictOf, SeesAStall) {
    const auto stalled = errors([](double h) { return h * h + 0.5 / (256.0 * 256.0); });
    EXPECT_EQ(stalled.verdict(), Verdict::not_asymptotic);
}

TEST(Defect, IsNamedForEverythingThatIsNoConvergence) {
    const auto defect = [](const Convergence& c) { return c.defect().value_or("none"); };
    EXPECT_EQ(defect(listed({16, 4, 1})), "none");
    EXPECT_NE(defect(listed({})).find("0 of at least 3 grids"), std::string::npos);
    EXPECT_NE(defect(listed({16, 4})).find("2 of at least 3 grids"), std::string::npos);
    EXPECT_NE(defect(listed({16, nan, 1})).find("grid 64: error is nan"), std::string::npos);
    EXPECT_NE(defect(listed({16, 4, 1.0 / 0.0})).find("grid 128: error is inf"), std::string::npos);
    EXPECT_NE(defect(listed({16, 4, -1})).find("negative"), std::string::npos);
    EXPECT_NE(defect(listed({4, 4, 4})).find("same error"), std::string::npos);
    EXPECT_NE(defect(listed({4, 4 * (1 + 1e-12), 4})).find("same error"), std::string::npos);
    EXPECT_NE(defect(listed({16, 4, 0})).find("round-off"), std::string::npos);
    EXPECT_NE(
        defect(Convergence({{1, 1.0, 1.0}, {2, 1.0, 0.5}, {4, 0.5, 0.1}})).find("same cell size"),
        std::string::npos);
    EXPECT_NE(
        defect(Convergence({{1, 1.0, 1.0}, {2, 0.0, 0.5}, {4, 0.5, 0.1}})).find("cell size is 0"),
        std::string::npos);
    EXPECT_NE(defect(Convergence({{1, 1.0, 1.0}, {2, 0.5, 0.5}, {4, 0.2, 0.1}}, nan))
                  .find("size of the truth"),
              std::string::npos);
}

// 1 MPa errors of a stress of 1 GPa are not at round-off, errors of 1e-4 Pa are; neither can be
// told without the scale.
TEST(Defect, KnowsRoundOffByTheSizeOfTheTruth) {
    const std::vector<Level> levels{
        {32, 1.0 / 32, 1.6e-3}, {64, 1.0 / 64, 4e-4}, {128, 1.0 / 128, 1e-4}};
    EXPECT_FALSE(Convergence(levels, 1.0).defect());
    EXPECT_TRUE(Convergence(levels, 1e9).defect());
}

TEST(Differences, NeedOneRatio) {
    EXPECT_THROW(from_differences({{32, 1.0 / 32, 1.0}, {64, 1.0 / 64, 0.3}, {96, 1.0 / 96, 0.1}}),
                 std::invalid_argument);
}

TEST(Differences, OfTwoGridsGiveNoOrder) {
    EXPECT_TRUE(from_differences({{32, 1.0 / 32, 1.0}}).defect());
}

TEST(Extrapolation, ClampsTheOrderAndWidensTheMargin) {
    const std::vector<double> h{4.0, 2.0, 1.0};
    const auto fast = extrapolate(h, std::vector{80.0, 8.0, 0.0}, 2.0);  // observed log2 9 = 3.17
    EXPECT_NEAR(fast.observed, std::log2(9.0), round_off);
    EXPECT_EQ(fast.order, 2.0);
    EXPECT_EQ(fast.safety, 3.0);
    EXPECT_NEAR(fast.uncertainty, 3.0 * 8.0 / 3.0, round_off);

    const auto slow = extrapolate(h, std::vector{2.1, 1.0, 0.0}, 2.0);  // observed log2 1.1 = 0.14
    EXPECT_EQ(slow.order, 0.5);
    EXPECT_EQ(slow.safety, 3.0);
    EXPECT_NEAR(slow.uncertainty, 3.0 / (std::sqrt(2.0) - 1.0), round_off);
}

TEST(Extrapolation, TrustsAnOrderWithinTenPerCentOfFormal) {
    const std::vector<double> h{4.0, 2.0, 1.0};
    const auto safety = [&](double p) {
        return extrapolate(h, std::vector{std::exp2(p) + 1.0, 1.0, 0.0}, 2.0).safety;
    };
    EXPECT_EQ(safety(1.81), 1.25);
    EXPECT_EQ(safety(1.79), 3.0);
    EXPECT_EQ(safety(2.19), 1.25);
    EXPECT_EQ(safety(2.21), 3.0);
}

// 1, 0, 0.25: the ratio of the differences says order 2, but the values swing about their limit.
TEST(Extrapolation, DistrustsValuesThatOscillate) {
    const std::vector<double> h{4.0, 2.0, 1.0};
    const auto swinging = extrapolate(h, std::vector{1.0, 0.0, 0.25}, 2.0);
    EXPECT_NEAR(swinging.observed, 2.0, round_off);
    EXPECT_EQ(swinging.safety, 3.0);
    EXPECT_EQ(extrapolate(h, std::vector{1.25, 0.25, 0.0}, 2.0).safety, 1.25);
}

TEST(Extrapolation, RefusesWhatItCannotUse) {
    EXPECT_TRUE(
        std::isnan(extrapolate(std::vector{4.0, 2.0, 1.0}, std::vector{1.0, nan, 3.0}, 2.0).value));
    EXPECT_THROW(extrapolate(std::vector{2.0, 1.0}, std::vector{1.0, 2.0}, 2.0),
                 std::invalid_argument);
    EXPECT_THROW(extrapolate(std::vector{1.0, 2.0, 4.0}, std::vector{1.0, 2.0, 3.0}, 2.0),
                 std::invalid_argument);
}

TEST(Extrapolate, TakesTwoValuesThatAreTheSame) {
    const std::vector<double> h{0.25, 0.125, 0.0625}, zero_and_round_off{0.0, 0.0, -2.2e-14};
    EXPECT_NEAR(extrapolate(h, zero_and_round_off, 2.0).value, 0.0, 1e-12);
}

}  // namespace
}  // namespace crawford::reports
