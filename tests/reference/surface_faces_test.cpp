/// The common face of a truth of a surface tells what its class tells, bit for bit and under the right name.
#include <gtest/gtest.h>

#include "reference/burning_sandwich_front.hpp"
#include "reference/carried_profile.hpp"
#include "reference/jumping_front.hpp"
#include "reference/refracted_front.hpp"
#include "reference/regressing_front.hpp"
#include "tests/reference/truth_at.hpp"

namespace crawford::reference {

namespace {

TEST(SurfaceFaces, CarriedProfile) {
    const CarriedProfile profile({.amplitude = 2.0,
                                  .period = 240e-6,
                                  .phase = 0.3,
                                  .column = ColumnShape::bump,
                                  .middle = -100e-6,
                                  .width = 50e-6});
    const Eigen::Vector2d velocity(0.001, 0.004);
    const Eigen::Vector2d start = Eigen::Vector2d(x, y) - velocity * t;
    const At at("carried-profile", {{"amplitude", 2.0},
                                    {"phase", 0.3},
                                    {"column", "bump"},
                                    {"middle", -100e-6},
                                    {"height", 50e-6},
                                    {"velocity_x", 0.001},
                                    {"velocity_y", 0.004}});
    EXPECT_EQ(at("profile"), profile.value(start));
    at.expect("profile_gradient", profile.gradient(start));
    EXPECT_EQ(at("profile_rate"), profile.rate(start, velocity, Eigen::Vector2d::Zero()));
}

TEST(SurfaceFaces, Fronts) {
    const RegressingWave wave(15e-6, 240e-6, 0.0045);
    const At smooth("regressing-wave", {{"amplitude", 15e-6}});
    EXPECT_EQ(smooth("surface"), wave.height(x, t));
    EXPECT_EQ(smooth("surface_slope"), wave.slope(x, t));
    EXPECT_EQ(At("regressing-wave-envelope", {{"amplitude", 15e-6}})("surface"),
              wave.envelope(x, t));
    EXPECT_EQ(At("regressing-zigzag", {{"right", 0.8}})("surface"),
              RegressingZigzag(0.8, 0.5, 240e-6, 0.0045).height(x, t));
}

TEST(SurfaceFaces, FrontsOfTwoRates) {
    const JumpingFront jumping({.width = 240e-6,
                                .left = -10e-6,
                                .right = 35e-6,
                                .strip_rate = 0.002,
                                .outer_rate = 0.005});
    const At strip("jumping-front", {{"left", -10e-6}, {"right", 35e-6}});
    EXPECT_EQ(strip("surface"), jumping.height(x, t));
    EXPECT_EQ(strip("surface_slope"), jumping.slope(x, t));

    const RefractedFront refracted({.left = 0.0,
                                    .right = 35e-6,
                                    .lean = 0.3,
                                    .slab_rate = 0.002,
                                    .outer_rate = 0.005,
                                    .width = 240e-6});
    const At slab("refracted-front", {{"left", 0.0}, {"right", 35e-6}, {"lean", 0.3}});
    EXPECT_EQ(slab("surface"), refracted.height(x, t));
    EXPECT_EQ(slab("surface_slope"), refracted.slope(x, t));
}

TEST(SurfaceFaces, BurningSandwichFront) {
    const BurningSandwichFront front(paper_sandwich(), paper_flame(), {.degree = 3, .layers = 3});
    const At at("burning-sandwich-front", {{"degree", 3.0}, {"layers", 3.0}});
    EXPECT_EQ(at("temperature"), front.temperature(x, y));
    EXPECT_EQ(at("surface"), front.height(x));
    EXPECT_EQ(at("surface_slope"), front.slope(x));
    EXPECT_EQ(at("surface_temperature"), front.surface_temperature(x));
    EXPECT_EQ(at("regression_rate"), front.regression_rate());
    EXPECT_EQ(at("regression_rate_uncertainty"), front.regression_rate_uncertainty());
    EXPECT_EQ(at("mean_burn_rate"), front.mean_burn_rate());
    EXPECT_EQ(at("interface_temperature"), front.interface_temperature());
    EXPECT_EQ(at("notch_depth"), front.notch_depth());
}

}  // namespace

}  // namespace crawford::reference
