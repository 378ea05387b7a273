// A burn has the same bits whatever else the program does at the time.
#include <gtest/gtest.h>

#include <array>
#include <future>
#include <vector>

#include "solver/run/loop.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

/// Large enough for the ordering of the unknowns to matter to the last digit.
Scene sandwich() {
    Scene scene;
    scene.domain = {.width = 240e-6, .depth = 480e-6, .nx = 32, .ny = 48, .half = true};
    scene.morphology = {Sandwich{60e-6}, {ammonium_perchlorate(), htpb_binder()}};
    scene.surface.pressure = 2e6;
    scene.surface.heat_flux = {8.368e6, 6.6944e6};
    scene.time = {.step = 20e-6, .end = 1e-3, .until_steady = {}};
    return scene;
}

/// The velocities after some steps, the unknowns ordered anew before each.
std::vector<Vector> velocities() {
    Simulation simulation(sandwich());
    for (int step = 0; step < 20; ++step) {
        simulation.forget_factorisation();
        run_steps(simulation, 1);
    }
    return simulation.state().velocity.values();
}

TEST(SolverRepeatable, TheSameBitsBesideAnotherRun) {
    const auto alone = velocities();
    std::array<std::future<std::vector<Vector>>, 3> beside;
    for (auto& run : beside) run = std::async(std::launch::async, velocities);
    for (auto& run : beside) EXPECT_TRUE(run.get() == alone);
}

}  // namespace

}  // namespace crawford
