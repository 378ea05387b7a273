#include "reference/jumping_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace crawford::reference {
namespace {

constexpr double width = 1.3, left = -0.21, right = 0.37;

JumpingFront front(double strip_rate, double outer_rate) {
    return JumpingFront({.width = width,
                         .left = left,
                         .right = right,
                         .strip_rate = strip_rate,
                         .outer_rate = outer_rate});
}

const JumpingFront slow_strip = front(0.3, 0.8);
const JumpingFront fast_strip = front(0.7, 0.4);

std::vector<double> places() {
    std::vector<double> x;
    for (int i = 0; i <= 40; ++i) x.push_back(-1.4 + 0.0717 * i);
    return x;
}

/// Time [s] in which the fastest path comes from y = 0 to depth d at a distance x from an
/// interface, inside the slower material: down the interface at `fast`, then straight at `slow`;
/// by trying where it leaves.
double fastest(double x, double depth, double fast, double slow) {
    const auto leaving = [&](double at) { return at / fast + std::hypot(x, depth - at) / slow; };
    constexpr int bits = 40;
    return std::min(depth / slow,
                    boost::math::tools::brent_find_minima(leaving, 0.0, depth, bits).second);
}

/// Burnt depth [m] at x; the slower material fills [from, to] and its images.
double depth_by_brute_force(const JumpingFront& jumping, double x, double t, double from, double to,
                            double fast, double slow) {
    if (jumping.rate(x) == fast) return fast * t;
    while (x > to) x -= width;
    while (x < from) x += width;
    const auto time = [&](double depth) {
        return std::min(fastest(x - from, depth, fast, slow), fastest(to - x, depth, fast, slow));
    };
    double low = 0.0, high = fast * t;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (time(middle) < t ? low : high) = middle;
    }
    return low;
}

TEST(JumpingFront, IsWhatTheFastestPathsReach) {
    for (const double t : {0.05, 0.4, 1.1, 5.0})
        for (const double x : places()) {
            EXPECT_NEAR(-slow_strip.height(x, t),
                        depth_by_brute_force(slow_strip, x, t, left, right, 0.8, 0.3), 1e-10);
            EXPECT_NEAR(-fast_strip.height(x, t),
                        depth_by_brute_force(fast_strip, x, t, right, left + width, 0.7, 0.4),
                        1e-6);
        }
}

TEST(JumpingFront, StartsLevelAndIsPeriodic) {
    for (const double x : places()) {
        EXPECT_EQ(slow_strip.height(x, 0.0), 0.0);
        EXPECT_NEAR(slow_strip.height(x + 3.0 * width, 0.6), slow_strip.height(x, 0.6), 1e-14);
    }
}

TEST(JumpingFront, ObeysItsEquationBetweenKinks) {
    for (const JumpingFront& jumping : {slow_strip, fast_strip})
        for (const double x : places()) {
            constexpr double t = 0.5, h = 1e-6;
            const auto kinks = jumping.kinks(t);
            const bool near_kink = std::ranges::any_of(kinks, [&](double kink) {
                return std::abs(std::remainder(x - kink, width)) < 1e-3;
            });
            if (near_kink) continue;
            const double slope = (jumping.height(x + h, t) - jumping.height(x - h, t)) / (2.0 * h);
            const double speed = (jumping.height(x, t + h) - jumping.height(x, t - h)) / (2.0 * h);
            EXPECT_NEAR(jumping.slope(x, t), slope, 1e-8);
            EXPECT_NEAR(speed, -jumping.rate(x) * std::hypot(1.0, slope), 1e-8);
        }
}

TEST(JumpingFront, KinksAreWhereTheSlopeJumps) {
    for (const JumpingFront& jumping : {slow_strip, fast_strip})
        for (const double t : {0.2, 20.0}) {
            const auto kinks = jumping.kinks(t);
            EXPECT_EQ(kinks.size(), t < 1.0 ? 4U : 3U);
            for (const double kink : kinks) {
                EXPECT_GE(kink, left);
                EXPECT_LT(kink, left + width);
                EXPECT_GT(std::abs(jumping.slope(kink + 1e-9, t) - jumping.slope(kink - 1e-9, t)),
                          0.5);
            }
        }
}

TEST(JumpingFront, MeanIsTheMean) {
    constexpr int samples = 20000;
    for (const JumpingFront& jumping : {slow_strip, fast_strip})
        for (const double t : {0.0, 0.3, 2.0, 9.0}) {
            double sum = 0.0;
            for (int i = 0; i < samples; ++i) sum += jumping.height(width * (i + 0.5) / samples, t);
            EXPECT_NEAR(jumping.mean_height(t), sum / samples, 1e-8);
        }
}

TEST(JumpingFront, FasterSideRulesInTheEnd) {
    EXPECT_NEAR(slow_strip.mean_height(9.0) - slow_strip.mean_height(8.0), -0.8, 1e-14);
    EXPECT_EQ(slow_strip.rate(left), 0.8);
    EXPECT_EQ(fast_strip.rate(right), 0.7);
}

TEST(JumpingFront, OneRateStaysLevel) {
    const JumpingFront level = front(0.5, 0.5);
    for (const double x : places()) {
        EXPECT_EQ(level.height(x, 2.0), -1.0);
        EXPECT_EQ(level.slope(x, 2.0), 0.0);
    }
    EXPECT_EQ(level.mean_height(2.0), -1.0);
    EXPECT_TRUE(level.kinks(2.0).empty());
}

TEST(JumpingFront, RefusesWhatIsMissingOrOutOfRange) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const JumpingRate good{
        .width = width, .left = left, .right = right, .strip_rate = 0.3, .outer_rate = 0.8};
    const auto with = [&](double JumpingRate::*member, double value) {
        JumpingRate rate = good;
        rate.*member = value;
        return rate;
    };
    EXPECT_THROW(JumpingFront(with(&JumpingRate::width, nothing)), std::invalid_argument);
    EXPECT_THROW(JumpingFront(with(&JumpingRate::left, nothing)), std::invalid_argument);
    EXPECT_THROW(JumpingFront(with(&JumpingRate::right, left)), std::invalid_argument);
    EXPECT_THROW(JumpingFront(with(&JumpingRate::right, left + width)), std::invalid_argument);
    EXPECT_THROW(JumpingFront(with(&JumpingRate::strip_rate, 0.0)), std::invalid_argument);
    EXPECT_THROW(JumpingFront(with(&JumpingRate::outer_rate, -1.0)), std::invalid_argument);
    EXPECT_THROW(slow_strip.height(0.0, -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
