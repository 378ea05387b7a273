// Exact heat past a disc: held against its own equation and the conditions on the circle.

#include "reference/conducting_inclusion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace crawford::reference {
namespace {

const DiscInHeat conditions{.inner_conductivity = 0.08,
                            .outer_conductivity = 0.4,
                            .radius = 1.0,
                            .temperature = 300.0,
                            .gradient_x = 2.0,
                            .gradient_y = -3.0,
                            .whole = 1.4,
                            .gone = 3.0};

/// Derivative by central differences, extrapolated once.
double slope(const std::function<double(double)>& f, double at) {
    const auto central = [&](double h) { return (f(at + h) - f(at - h)) / (2.0 * h); };
    return (4.0 * central(5e-4) - central(1e-3)) / 3.0;
}

TEST(ConductingInclusion, ConductsTheSameHeatOnBothSidesOfTheCircle) {
    const ConductingInclusion truth(conditions);
    for (int k = 0; k < 9; ++k) {
        const double angle = 0.1 + 0.7 * k;
        const double x = std::cos(angle);
        const double y = std::sin(angle);
        const auto along_ray = [&](double r) { return truth.temperature(r * x, r * y); };
        EXPECT_NEAR(along_ray(1.0 - 1e-12), along_ray(1.0 + 1e-12), 1e-9);
        const double inside = (along_ray(1.0) - along_ray(0.5)) / 0.5;  // even inside
        const double outside = slope(along_ray, 1.0 + 2e-3);
        // the flux falls as the dipole does: by 2 (2e-3) of its strength at most
        EXPECT_NEAR(0.08 * inside, 0.4 * outside, 0.4 * 4e-3 * std::hypot(2.0, 3.0)) << angle;
    }
}

TEST(ConductingInclusion, ItsSourceIsWhatConductionLacks) {
    const ConductingInclusion truth(conditions);
    for (const auto& point : {std::pair{1.1, 0.3}, {1.5, 0.4}, {-1.2, 1.7}, {0.3, -2.4}}) {
        const double x = point.first;
        const double y = point.second;
        const auto second = [&](double ux, double uy) {
            const auto line = [&](double s) {
                return slope([&](double t) { return truth.temperature(x + t * ux, y + t * uy); },
                             s);
            };
            return slope(line, 0.0);
        };
        EXPECT_NEAR(truth.source(x, y), -0.4 * (second(1, 0) + second(0, 1)), 1e-5)
            << x << ' ' << y;
    }
}

TEST(ConductingInclusion, IsEvenWithoutContrastAndGoneFarAway) {
    DiscInHeat same = conditions;
    same.inner_conductivity = same.outer_conductivity;
    const ConductingInclusion truth(same);
    EXPECT_NEAR(truth.temperature(0.7, -0.9), 300.0 + 2.0 * 0.7 + 3.0 * 0.9, 1e-12);
    EXPECT_EQ(truth.temperature(3.0, 1.0), 300.0);
    EXPECT_EQ(truth.source(3.0, 1.0), 0.0);
    EXPECT_EQ(truth.source(0.5, 0.1), 0.0);
}

TEST(ConductingInclusion, NamesWhatIsWrong) {
    const auto refusal = [](DiscInHeat disc) -> std::string {
        try {
            ConductingInclusion{disc};
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    DiscInHeat disc = conditions;
    disc.radius = missing;
    EXPECT_NE(refusal(disc).find("radius"), std::string::npos);
    disc = conditions;
    disc.inner_conductivity = 0.0;
    EXPECT_NE(refusal(disc).find("inner_conductivity"), std::string::npos);
    disc = conditions;
    disc.whole = 0.9;
    EXPECT_NE(refusal(disc).find("whole"), std::string::npos);
    disc = conditions;
    disc.gone = 1.2;
    EXPECT_NE(refusal(disc).find("gone"), std::string::npos);
}

}  // namespace
}  // namespace crawford::reference
