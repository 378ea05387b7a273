#include "solver/reference_map/reference_map.hpp"

#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

TEST(ReferenceMap, FollowsASimpleShearExactlyUnderAMovingSlopedSurface) {
    // v = (gamma (y + L), 0) from rest: the shift is -gamma t (y + L) in x, F = ((1, gamma t), (0,
    // 1)). Linear in space and time, so any consistent scheme is exact, also on a grid that moves
    // through the material.
    const Grid grid({.width = 1.0, .depth = 1.0, .nx = 8, .ny = 8, .clustering = 0.0});
    const double gamma = 0.3;
    const double sink = -0.2;
    const double dt = 0.01;
    SurfaceField surface(8, 0.0);
    const SurfaceField rate(8, sink);
    NodeVectors velocity(8, 9);
    NodeVectors shift(8, 9);
    for (int k = 0; k < 20; ++k) {
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j <= 8; ++j)
                velocity(i, j) = {gamma * (surface[size_t(i)] + grid.eta(j) + 1.0), 0.0};
        for (int i = 0; i < 8; ++i) shift(i, 0) = {-gamma * k * dt * surface[size_t(i)], 0.0};
        advance_reference_map(grid, {surface, rate, velocity}, dt, shift);
        for (double& height : surface) height += sink * dt;
    }
    const double t = 20 * dt;
    for (int j = 2; j < 8; ++j) {
        const Eigen::Matrix2d f = deformation_gradient(grid, surface, shift)(4, j);
        EXPECT_NEAR(f(0, 1), gamma * t, 2e-3)
            << j;  // the inflow is fed a step late: gamma dt |sink| in size
        EXPECT_NEAR(f(0, 0), 1.0, 1e-10);
        EXPECT_NEAR(f(1, 1), 1.0, 1e-10);
    }
}

TEST(ReferenceMap, GreenStrainIsBlindToRotation) {
    Eigen::Matrix2d rotation;
    rotation << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
    EXPECT_NEAR(green_strain(rotation).norm(), 0.0, 1e-15);
    Eigen::Matrix2d stretch = Eigen::Matrix2d::Identity();
    stretch(1, 1) = 1.2;
    EXPECT_NEAR(green_strain(rotation * stretch)(1, 1), 0.22, 1e-15);  // (1.44 - 1)/2
}

}  // namespace
}  // namespace crawford
