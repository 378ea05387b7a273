// The first load presses the solid and carries nothing.
#include <gtest/gtest.h>

#include "solver/run/loop.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

double rate_after(double pressure, Stepping scheme) {
    Scene scene = testing::sandwich(32, 96);
    scene.surface.pressure = pressure;
    scene.time = {.step = 80e-6, .end = 0.1, .scheme = scheme};
    Simulation simulation(scene);
    run_steps(simulation, 40);
    return simulation.summary().regression_rate;
}

TEST(FirstLoad, OfAHundredMegapascalsBurnsAsOneOfTwo) {
    for (const Stepping scheme : {Stepping::euler, Stepping::bdf2})
        EXPECT_NEAR(rate_after(100e6, scheme) / rate_after(2e6, scheme), 1.0, 1e-3);
}

/// A slab of AP under 100 MPa that hardly burns.
Scene pressed_slab() {
    Scene scene = testing::slab(ammonium_perchlorate(), 24);
    scene.surface.pressure = 100e6;
    scene.surface.heat_flux = {0.0};
    scene.surface.burn_rate = 1e-9;
    scene.time.step = 1e-6;
    return scene;
}

/// By how much the load shortens it where it cannot widen [m].
double shortening() {
    const Material ap = ammonium_perchlorate();
    return 100e6 * 480e-6 / (ap.bulk_modulus + 4.0 / 3.0 * ap.shear_modulus);
}

TEST(FirstLoad, LeavesTheSolidPressedAndAtRest) {
    Simulation simulation(pressed_slab());
    run_steps(simulation, 2);
    const State& state = simulation.state();
    EXPECT_NEAR(state.reference_shift(0, 24).y(), shortening(), 1e-10);
    EXPECT_NEAR(state.stress.mean(0, 12).s22, -100e6, 1.0);
    EXPECT_LT(std::abs(state.velocity(0, 24).y()), 1e-6);
}

TEST(FirstLoad, TakesTheSurfaceAlongWhereItMovesWithTheMaterial) {
    Scene scene = pressed_slab();
    scene.numerics.surface_motion = SurfaceMotion::burning_with_material;
    Simulation simulation(scene);
    run_steps(simulation, 1);
    EXPECT_NEAR(simulation.state().surface[0], -shortening(), 1e-10);
}

}  // namespace
}  // namespace crawford
