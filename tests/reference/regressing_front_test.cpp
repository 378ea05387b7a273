#include "reference/regressing_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace crawford::reference {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double amplitude = 0.11, period = 1.3, burn_rate = 0.7;
constexpr double k = 2.0 * std::numbers::pi / period;

const RegressingWave wave(amplitude, period, burn_rate);
const RegressingZigzag zigzag(0.9, 0.4, period, burn_rate);

std::vector<double> places() {
    std::vector<double> x;
    for (int i = 0; i <= 26; ++i) x.push_back(-1.0 + 0.083 * i);
    return x;
}

/// Fourth-order central difference.
template <class Function>
double derivative(const Function& f, double at, double h) {
    return (8.0 * (f(at + h) - f(at - h)) - (f(at + 2 * h) - f(at - 2 * h))) / (12.0 * h);
}

/// Lower envelope of circles about every point of a first surface, by brute force: wrong by
/// some curvature x (spacing)^2 at most.
template <class Start>
double brute_envelope(const Start& start, double x, double reach) {
    constexpr int samples = 40000;
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= samples; ++i) {
        const double offset = reach * (2.0 * i / samples - 1.0);
        lowest = std::min(
            lowest, start(x + offset) - std::sqrt(std::max(reach * reach - offset * offset, 0.0)));
    }
    return lowest;
}

double wave_start(double x) {
    return amplitude * std::cos(k * x);
}

double zigzag_start(double x) {
    const double from_left = x - period * std::floor(x / period);
    return std::min(0.9 * from_left, 0.4 * (period - from_left));
}

TEST(RegressingWave, StartsAsACosine) {
    for (const double x : places()) {
        EXPECT_NEAR(wave.height(x, 0.0), wave_start(x), 1e-15);
        EXPECT_NEAR(wave.envelope(x, 0.0), wave_start(x), 1e-15);
    }
}

TEST(RegressingWave, ObeysItsEquationBeforeTheKink) {
    const double t = 0.6 * wave.kink_time();
    for (const double x : places()) {
        const double p = derivative([&](double s) { return wave.height(s, t); }, x, 1e-3);
        const double rate = derivative([&](double s) { return wave.height(x, s); }, t, 1e-3 * t);
        EXPECT_NEAR(p, wave.slope(x, t), 1e-6);
        EXPECT_NEAR(rate, -burn_rate * std::hypot(1.0, wave.slope(x, t)), 1e-8);
    }
}

TEST(RegressingWave, CharacteristicsAndEnvelopeAgreeBeforeTheKink) {
    for (const double part : {0.1, 0.5, 0.9, 0.999})
        for (const double x : places()) {
            const double t = part * wave.kink_time();
            EXPECT_NEAR(wave.envelope(x, t), wave.height(x, t), 1e-14);
        }
}

TEST(RegressingWave, KinksWhenItsCrestIsBurntThrough) {
    // The curvature of the crest grows as 1/(R - r_b t), R = 1/(A k^2).
    const double radius = 1.0 / (amplitude * k * k);
    EXPECT_NEAR(wave.kink_time(), radius / burn_rate, 1e-15);
    const double t = 0.75 * wave.kink_time();
    const double curvature = -derivative([&](double s) { return wave.slope(s, t); }, 0.0, 1e-4);
    EXPECT_NEAR(curvature, 4.0 / radius, 1e-4 / radius);
    EXPECT_TRUE(std::isinf(RegressingWave(0.0, period, burn_rate).kink_time()));
}

TEST(RegressingWave, IsTheLowestOfAllCirclesAfterTheKink) {
    for (const double part : {1.5, 4.0, 20.0})
        for (const double x : places()) {
            const double t = part * wave.kink_time();
            const double brute = brute_envelope(wave_start, x, burn_rate * t);
            EXPECT_LE(wave.envelope(x, t), brute + 1e-14);
            EXPECT_NEAR(wave.envelope(x, t), brute, 1e-6);
        }
}

TEST(RegressingWave, EndsAsArcsAboutItsValleys) {
    // Long after, only circles about the valleys are left, of radius r_b t + 1/(A k^2).
    const double late = 200.0 * wave.kink_time();
    const double radius = burn_rate * (late + wave.kink_time());
    const double valley = wave.envelope(0.5 * period, late);
    EXPECT_NEAR(valley, -amplitude - burn_rate * late, 1e-13);
    EXPECT_NEAR(wave.envelope(0.0, late) - valley, period * period / (8.0 * radius), 1e-6);
}

TEST(RegressingWave, IsKnownForAllTimes) {
    for (const double t : {1e-300, 1e9, 1e290}) {
        EXPECT_NEAR(wave.envelope(0.5 * period, t), -amplitude - burn_rate * t,
                    1e-15 * (amplitude + burn_rate * t));
        EXPECT_LE(wave.envelope(0.1 * period, t), amplitude - burn_rate * t);
    }
    EXPECT_EQ(wave.height(0.1 * period, 1e-300), wave_start(0.1 * period));
}

TEST(RegressingZigzag, IsTheLowestOfAllCircles) {
    for (const double t : {0.05, 0.4, 1.7})
        for (const double x : places()) {
            const double brute = brute_envelope(zigzag_start, x, burn_rate * t);
            EXPECT_NEAR(zigzag.height(x, t), brute, 2e-4 * burn_rate * t);
            EXPECT_LE(zigzag.height(x, t), brute + 1e-14);
        }
}

TEST(RegressingZigzag, OpensIntoArcsOfTheBurntDepth) {
    const double t = 0.4, radius = burn_rate * t;
    for (const double part : {-0.3, -0.1, 0.0, 0.2, 0.6}) {
        const double x = part * radius;
        EXPECT_NEAR(std::hypot(x, zigzag.height(x, t)), radius, 1e-15);
    }
    // Beyond them both flanks recede along their normals.
    EXPECT_NEAR(zigzag.height(0.3, t), 0.9 * 0.3 - radius * std::hypot(1.0, 0.9), 1e-15);
    EXPECT_NEAR(zigzag.height(-0.2, t), 0.4 * 0.2 - radius * std::hypot(1.0, 0.4), 1e-15);
}

TEST(RegressingZigzag, CrestsWanderAtTheRateOfTheirJump) {
    // Rankine-Hugoniot: dx/dt = [H]/[p] with H = r_b sqrt(1 + p^2) between p = 0.9 and p = -0.4.
    const double t = 0.3;
    const double start = period * 0.4 / (0.9 + 0.4);
    const double wander = burn_rate * (std::hypot(1.0, 0.9) - std::hypot(1.0, 0.4)) / (0.9 + 0.4);
    const double crest = start + wander * t;
    const double height = zigzag.height(crest, t);
    EXPECT_NEAR(zigzag.height(crest - 1e-3, t), height - 0.9e-3, 1e-14);
    EXPECT_NEAR(zigzag.height(crest + 1e-3, t), height - 0.4e-3, 1e-14);
}

TEST(RegressingFront, RefusesWhatIsMissingOrOutOfRange) {
    EXPECT_THROW(RegressingWave(missing, period, burn_rate), std::invalid_argument);
    EXPECT_THROW(RegressingWave(-0.1, period, burn_rate), std::invalid_argument);
    EXPECT_THROW(RegressingWave(amplitude, 0.0, burn_rate), std::invalid_argument);
    EXPECT_THROW(RegressingWave(amplitude, period, 0.0), std::invalid_argument);
    EXPECT_THROW(wave.height(0.0, -1.0), std::invalid_argument);
    EXPECT_THROW(wave.height(0.0, wave.kink_time()), std::invalid_argument);
    EXPECT_THROW(wave.slope(0.0, 2.0 * wave.kink_time()), std::invalid_argument);
    EXPECT_THROW(wave.envelope(0.0, -1.0), std::invalid_argument);
    EXPECT_THROW(RegressingZigzag(0.0, 0.4, period, burn_rate), std::invalid_argument);
    EXPECT_THROW(RegressingZigzag(0.9, missing, period, burn_rate), std::invalid_argument);
    EXPECT_THROW(RegressingZigzag(0.9, 0.4, -1.0, burn_rate), std::invalid_argument);
    EXPECT_THROW(RegressingZigzag(0.9, 0.4, period, missing), std::invalid_argument);
    EXPECT_THROW(zigzag.height(0.0, -0.1), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
