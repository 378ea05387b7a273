// The line relaxation stops by its error, not by its last change.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/run/loop.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

double rate_with(double tolerance) {
    Scene scene = testing::sandwich(256, 24);
    scene.domain.half = true;
    scene.physics.mechanics = scene.physics.reference_map = false;
    scene.numerics.heat_tolerance = tolerance;
    scene.time = {.step = 80e-6, .end = 0.1};
    Simulation simulation(scene);
    run_steps(simulation, 60);
    return simulation.summary().mean_burn_rate;
}

TEST(LineRelaxation, ACoarseToleranceStillBurnsAtTheRightRate) {
    const double right = rate_with(1e-12);
    for (const double tolerance : {1e-10, 1e-6, 1e-3, 1e-2})
        EXPECT_NEAR(rate_with(tolerance) / right, 1.0, 2e-3) << tolerance;
}

TEST(LineRelaxation, StopsAtRoundOffWhateverItIsAskedFor) {
    EXPECT_NEAR(rate_with(1e-15) / rate_with(1e-12), 1.0, 1e-9);
}

}  // namespace
}  // namespace crawford
