#include "reports/gate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "reports/judgement.hpp"

namespace crawford::reports {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<int> grids{32, 64, 128, 256};

Convergence of_order(double p) {
    std::vector<Level> levels;
    for (const int n : grids) levels.push_back({n, 1.0 / n, std::pow(1.0 / n, p)});
    return Convergence(levels);
}

Convergence with(std::vector<double> errors, const std::vector<int>& on = grids) {
    std::vector<Level> levels;
    for (std::size_t i = 0; i < errors.size(); ++i)
        levels.push_back({on[i], 1.0 / on[i], errors[i]});
    return Convergence(levels);
}

Gate second_order(Expectation expected = expect(2.0).within(0.1)) {
    return {"temperature", Norm::L2, expected, "central differences"};
}

GateResult judged(const Convergence& convergence) {
    return judge(second_order(), convergence, grids);
}

TEST(OrderGate, PassesTheOrderItExpects) {
    const auto result = judged(of_order(2.0));
    EXPECT_TRUE(result.passed) << result.failure;
    EXPECT_NEAR(result.fit, 2.0, 1e-12);
    EXPECT_EQ(result.verdict, "monotone");
    EXPECT_EQ(result.pairwise.size(), 3U);
    EXPECT_EQ(result.coarsest, 32);
    EXPECT_EQ(result.finest, 256);
    // The error of an exact power vanishes as h -> 0: what is left is round-off of the finest
    // error, 1.5e-5.
    EXPECT_NEAR(result.limit.value, 0.0, 1e-15);
}

TEST(OrderGate, HoldsBothEndsOfItsTolerance) {
    EXPECT_TRUE(judged(of_order(1.91)).passed);
    EXPECT_FALSE(judged(of_order(1.89)).passed);
    EXPECT_TRUE(judged(of_order(2.09)).passed);
    EXPECT_FALSE(judged(of_order(2.11)).passed);
    EXPECT_TRUE(judge(second_order(expect(2.0).or_better(0.1)), of_order(3.0), grids).passed);
    EXPECT_FALSE(judge(second_order(expect(2.0).or_better(0.1)), of_order(1.8), grids).passed);
    EXPECT_TRUE(judge(second_order(expect(2.0).within(0.1, 0.6)), of_order(2.5), grids).passed);
}

TEST(OrderGate, NeverPassesWhatIsNoConvergence) {
    const auto failure = [](const Convergence& c) {
        const auto result = judged(c);
        EXPECT_FALSE(result.passed);
        return result.failure;
    };
    EXPECT_EQ(failure(with({256, 64, 16, nan})), "grid 256: error is nan");
    EXPECT_EQ(failure(with({nan, 64, 16, 4})), "grid 32: error is nan");
    EXPECT_NE(failure(with({4, 4, 4, 4})).find("same error"), std::string::npos);
    EXPECT_NE(failure(with({1e-16, 1e-16 / 4, 1e-16 / 16, 1e-16 / 64})).find("round-off"),
              std::string::npos);
    EXPECT_NE(failure(with({64, 16, 4}, {64, 128, 256})).find("no error from grid 32"),
              std::string::npos);
    EXPECT_NE(failure(with({})).find("no error from grid 32, 64, 128, 256"), std::string::npos);
    EXPECT_NE(failure(with({1, 4, 16, 64})).find("diverging"), std::string::npos);
    EXPECT_NE(failure(with({256, 64, 70, 4})).find("oscillating"), std::string::npos);
    EXPECT_NE(failure(with({256, 64, 16, 8})).find("not asymptotic"), std::string::npos);
    EXPECT_NE(judge(second_order(), with({64, 16}), {32, 64}).failure.find("2 of at least 3"),
              std::string::npos);
    EXPECT_NE(judge(second_order(), with({}), {}).failure.find("0 of at least 3"),
              std::string::npos);
}

TEST(OrderGate, FitsTheRangeItNamesAndStillWantsTheRest) {
    const auto late = second_order(expect(2.0).within(0.1).from(64).to(256));
    EXPECT_TRUE(judge(late, with({64.1, 64, 16, 4}), grids).passed);
    EXPECT_FALSE(judged(with({64.1, 64, 16, 4})).passed);
    EXPECT_EQ(judge(late, with({nan, 64, 16, 4}), grids).failure, "grid 32: error is nan");
    EXPECT_NE(judge(late, with({64, 16, 4}, {32, 64, 128}), {32, 64, 128})
                  .failure.find("no error from grid 256"),
              std::string::npos)
        << "the finest grid of the gate was not run";
}

TEST(OrderGate, WithoutAReasonFails) {
    auto gate = second_order();
    gate.reason = "";
    EXPECT_FALSE(judge(gate, of_order(2.0), grids).passed);
}

TEST(BoundGate, HoldsItsInterval) {
    const Bound bound{"T_s - exact [K]", between(-1.0, 1.0), "a quarter of the model difference"};
    EXPECT_TRUE(judge(bound, 0.9).passed);
    EXPECT_TRUE(judge(bound, -1.0).passed);
    EXPECT_FALSE(judge(bound, 1.1).passed);
    EXPECT_FALSE(judge(bound, nan).passed);
    EXPECT_FALSE(judge(bound, std::numeric_limits<double>::infinity()).passed);
    EXPECT_FALSE(
        judge({"x", at_least(0.0), "sign"}, std::numeric_limits<double>::infinity()).passed);
    EXPECT_TRUE(judge({"x", at_most(0.02), "no zigzag"}, -5.0).passed);
    EXPECT_FALSE(judge({"x", at_most(0.02), ""}, 0.0).passed) << "no reason given";
}

std::vector<GateResult> some_results() {
    auto passing = judged(of_order(2.0));
    auto failing = judge(second_order(expect(2.0).or_better(0.1)), with({256, 64, 16, nan}), grids);
    failing.failure += fmt::format(" {:x<300}", "");
    auto bound =
        judge(Bound{"T_s [K]", between(0.0, 1.0), fmt::format("why {:y<150} not", "")}, 0.5);
    for (auto* result : {&passing, &failing, &bound}) result->study = "slab, AP";
    failing.grids.resize(12, 512);  // more grids than stand on one line
    failing.h.resize(12, 0.1);
    failing.errors.resize(12, 1e-300);
    failing.pairwise.resize(11, -100.0);
    return {passing, failing, bound};
}

TEST(Table, StaysWithinAHundredColumns) {
    auto results = some_results();
    for (int i = 0; i < 40; ++i) results[0].reason += " and so on";
    std::istringstream lines(table(results));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST(Table, ShowsWhatTheJudgementRestsOn) {
    const auto text = table(some_results());
    for (const char* part :
         {"slab, AP", "temperature, L2", "pass", "FAIL: grid 256: error is nan", "3.906e-03",
          "2.000", "fit 2.000, monotone", "because central differences"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(Table, CountsHowManyCameOutHow) {
    auto results = some_results();
    EXPECT_EQ(text(count(results)), "2 pass, 1 fail");
    leave_ungated(results[0], {128, 256});
    EXPECT_EQ(text(count(results)), "1 pass, 1 fail, 1 not gated: too few grids");
    EXPECT_EQ(results[0].failure, "too few grids to gate: 128, 256 not run");
    EXPECT_FALSE(results[0].fell_short());
    EXPECT_FALSE(all_passed({results[0]}));
    EXPECT_EQ(text(count({results[2]})), "1 of 1 gates pass");
}

TEST(Table, OfNothingIsNoSuccess) {
    EXPECT_FALSE(all_passed({}));
    EXPECT_NE(text(count({})).find("no gates"), std::string::npos);
}

}  // namespace
}  // namespace crawford::reports
