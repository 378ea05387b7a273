// Verdicts of the ledger.
#include "reports/claim.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace crawford::reports {
namespace {

const Claim burn_rate{"mean burn rate", "Fig. 15b", "fig15", "cm/s", "0.42", 0.42, 0.005};

Found found(double value, Uncertainty uncertainty = {}, std::vector<OtherReading> others = {}) {
    return {.value = value,
            .uncertainty = uncertainty,
            .reading = "as read",
            .others = std::move(others)};
}

TEST(Claim, IsReproducedWithinWhatPrintingLeavesOpen) {
    EXPECT_EQ(judged(burn_rate, found(0.4249)).standing, Standing::reproduced);
    EXPECT_EQ(judged(burn_rate, found(0.4151)).standing, Standing::reproduced);
    EXPECT_EQ(judged(burn_rate, found(0.4251)).standing, Standing::not_reproduced);
}

TEST(Claim, IsReproducedWithinOurUncertaintyBesides) {
    EXPECT_EQ(judged(burn_rate, found(0.44, {.grid = 0.003, .step = 0.004})).standing,
              Standing::not_reproduced)
        << "0.005 and 0.005 are less than 0.02";
    EXPECT_EQ(judged(burn_rate, found(0.44, {.grid = 0.012, .packs = 0.01})).standing,
              Standing::reproduced);
}

TEST(Claim, IsReproducedUnderTheFirstOtherReadingThatAgrees) {
    const auto row = judged(
        burn_rate, found(0.5, {}, {{"alpha K", 0.47}, {"c_v", 0.421}, {"1000 J/(kg K)", 0.42}}));
    EXPECT_EQ(row.standing, Standing::other_reading);
    EXPECT_NE(row.why.find("0.421 with: c_v"), std::string::npos) << row.why;
    EXPECT_EQ(row.reading, "as read") << "of our own number";
    EXPECT_EQ(*row.value, 0.5);
}

TEST(Claim, ReadsWhatTheLastDigitLeavesOpen) {
    EXPECT_DOUBLE_EQ(half_digit("0.42"), 0.005);
    EXPECT_DOUBLE_EQ(half_digit("975.9"), 0.05);
    EXPECT_DOUBLE_EQ(half_digit("2"), 0.5);
}

TEST(Claim, IsNoRowWithoutANumber) {
    EXPECT_THROW(judged(burn_rate, found(std::numeric_limits<double>::quiet_NaN())),
                 std::invalid_argument);
}

TEST(Claim, InWordsHoldsOrDoesNot) {
    const Statement cools{"mechanics cools", "Fig. 10", "fig10",    "a drop", "-8 K",
                          "as read",         true,      "both fall"};
    EXPECT_EQ(judged(cools).standing, Standing::reproduced);
    Statement warms = cools;
    warms.holds = false;
    EXPECT_EQ(judged(warms).standing, Standing::not_reproduced);
    EXPECT_FALSE(judged(warms).value.has_value());
}

}  // namespace
}  // namespace crawford::reports
