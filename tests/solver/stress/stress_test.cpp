#include <gtest/gtest.h>

#include <limits>

#include "solver/stress/stress_step.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

/// A solid at rest under a level surface, for calls of one module alone.
struct Bench {
    explicit Bench(Scene s)
        : scene(std::move(s)),
          grid(scene.domain),
          materials(scene.morphology, grid),
          checkerboard(grid, materials, scene.numerics.element),
          step(scene, grid, materials, checkerboard, {}),
          surface(size_t(grid.node_columns()), 0.0),
          surface_rate(surface),
          velocity(grid.node_columns(), grid.rows() + 1),
          stress(grid.cell_columns(), grid.rows(), 4) {}

    SolidMotion motion() const { return {surface, surface_rate, velocity}; }

    Scene scene;
    Grid grid;
    MaterialMap materials;
    Checkerboard checkerboard;
    StressStep step;
    SurfaceField surface, surface_rate;
    NodeVectors velocity;
    StressField stress;
};

Scene uniform(int nx, int ny) {
    Scene scene = testing::sandwich(nx, ny);
    scene.domain.clustering = 0.0;
    scene.morphology = {.shape = Uniform{}, .materials = {ammonium_perchlorate()}};
    return scene;
}

TEST(Stress, TurnsWithTheBody) {
    // A rigid rotation by one radian: by the Jaumann rate the principal stresses stay and the axes
    // turn with the body. Euler steps of 1/4000 leave an error of 2 dt of the size; measured 5e-4.
    Bench b(uniform(8, 8));
    const double turn_rate = 1.0;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j <= 8; ++j)
            b.velocity(i, j) = turn_rate * Vector(-b.grid.eta(j), b.grid.x(i));
    const Deviator start{3e6, -1e6, 2e6};
    for (auto& point : b.stress.deviator) std::ranges::fill(point.values(), start);
    const int steps = 4000;
    for (int k = 0; k < steps; ++k) {
        // The same everywhere, so advection has nothing to carry, also where the window wraps
        // around.
        b.step.predict(b.stress, b.motion(), {}, 0.0, 1.0 / steps);
        const Deviator inside = b.stress.deviator[0](3, 3);
        for (auto& point : b.stress.deviator) std::ranges::fill(point.values(), inside);
    }
    Eigen::Matrix2d s;
    s << start.s11, start.s12, start.s12, start.s22;
    const Eigen::Matrix2d q =
        (Eigen::Matrix2d() << std::cos(1.0), -std::sin(1.0), std::sin(1.0), std::cos(1.0))
            .finished();
    const Eigen::Matrix2d turned = q * s * q.transpose();
    const Deviator& found = b.stress.deviator[0](3, 3);
    EXPECT_NEAR(found.s11, turned(0, 0), 2e-3 * s.norm());
    EXPECT_NEAR(found.s22, turned(1, 1), 2e-3 * s.norm());
    EXPECT_NEAR(found.s12, turned(0, 1), 2e-3 * s.norm());
}

TEST(Stress, NeverReadsAcrossAMaterial) {
    Bench b(testing::sandwich(16, 12));
    const double poison = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 12; ++j)
            if (b.materials.fraction()(i, j) == 1.0) {
                for (auto& point : b.stress.deviator) point(i, j) = {poison, poison, poison};
                b.stress.pressure(i, j) = poison;
            }
    std::ranges::fill(b.velocity.values(), Vector(1e-3, 2e-3));
    for (const double direction : {1.0, -1.0}) {
        for (Vector& v : b.velocity.values()) v *= direction;
        b.step.predict(b.stress, b.motion(), {}, 0.0, 1e-5);
    }
    for (int i = 6; i < 10; ++i)
        for (int j = 0; j < 12; ++j) {
            EXPECT_TRUE(std::isfinite(b.stress.pressure(i, j))) << i << " " << j;
            EXPECT_TRUE(std::isfinite(b.stress.deviator[0](i, j).s11)) << i << " " << j;
        }
}

TEST(Stress, CarriesASmoothProfileUpwardToThirdOrder) {
    // One step of a parabola in y: WENO3 differences it exactly but for its weights, on a uniform
    // grid.
    Bench b(uniform(4, 16));
    std::ranges::fill(b.velocity.values(), Vector(0.0, 1.0));
    const auto profile = [&](double y) { return 1e9 * y + 1e12 * y * y; };
    const auto centre = [&](int j) { return 0.5 * (b.grid.eta(j) + b.grid.eta(j + 1)); };
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 16; ++j) b.stress.pressure(i, j) = profile(centre(j));
    const double dt = 1e-6;
    b.step.predict(b.stress, b.motion(), {}, 0.0, dt);
    for (int j = 2; j < 16; ++j) {
        const double slope = 1e9 + 2e12 * centre(j);
        EXPECT_NEAR(b.stress.pressure(1, j), profile(centre(j)) - dt * slope,
                    1e-6 * std::abs(dt * slope))
            << j;
    }
}

TEST(Stress, HeatRaisesThePressureByBetaTimesTheRate) {
    Bench b(uniform(4, 8));
    b.step.predict(b.stress, b.motion(), CellField(4, 8, 1000.0), 0.0, 1e-3);
    EXPECT_NEAR(b.stress.pressure(1, 3), 3 * 1e-5 * 14950e6, 1.0);  // 1 K warmer
}

TEST(Stress, FollowsHookesLawInUniaxialStrain) {
    Bench b(uniform(4, 8));
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= 8; ++j) b.velocity(i, j) = {0.0, 2.0 * b.grid.eta(j)};
    b.step.correct(b.stress, b.surface, b.velocity, 1e-3);  // a strain of 0.002
    const double lame = 14950e6 - 2.0 / 3.0 * 12500e6;
    const PlaneStress s = b.stress.mean(2, 4);
    EXPECT_NEAR(s.s22, (lame + 2 * 12500e6) * 0.002, 1.0);
    EXPECT_NEAR(s.s11, lame * 0.002, 1.0);
    EXPECT_NEAR(s.s33, lame * 0.002, 1.0);
    EXPECT_NEAR(s.s12, 0.0, 1e-6);
}

TEST(Stress, ASofterCellCannotHoldWhatItHeld) {
    Bench b(uniform(4, 8));
    for (auto& point : b.stress.deviator)
        std::ranges::fill(point.values(), Deviator{1e6, -1e6, 5e5});
    b.step.soften(b.stress, CellField(4, 8, 4.0 * 12500e6));  // was four times as stiff
    EXPECT_NEAR(b.stress.deviator[2](1, 1).s11, 2.5e5, 1e-6);
    b.step.soften(b.stress, CellField(4, 8, 0.5 * 12500e6));  // was softer: nothing happens
    EXPECT_NEAR(b.stress.deviator[2](1, 1).s11, 2.5e5, 1e-6);
}

}  // namespace
}  // namespace crawford
