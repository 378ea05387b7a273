#include "reports/alternation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace crawford::reports {
namespace {

TEST(Alternation, IsOneForAZigzagAndNothingForACubic) {
    std::vector<double> zigzag;
    std::vector<double> cubic;
    for (int k = 0; k < 12; ++k) {
        zigzag.push_back(k % 2 == 0 ? 3.0 : -3.0);
        cubic.push_back(1.0 + k - 2.0 * k * k + 0.5 * k * k * k);
    }
    EXPECT_NEAR(alternation(zigzag), 1.0, 1e-14);
    EXPECT_NEAR(alternation(cubic), 0.0, 1e-14);
}

TEST(Alternation, OfHalfALineSeesItsMirrorImage) {
    // |x| has a kink on the axis when it is mirrored as it is, and none when its sign changes
    // there.
    const std::vector<double> half{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
    EXPECT_GT(alternation_of_half(half, 1.0), 0.01);
    EXPECT_NEAR(alternation_of_half(half, -1.0), 0.0, 1e-14);
}

TEST(Alternation, NeedsFiveValues) {
    EXPECT_THROW(alternation({1.0, 2.0, 1.0, 2.0}), std::invalid_argument);
    EXPECT_EQ(alternation({0.0, 0.0, 0.0, 0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace crawford::reports
