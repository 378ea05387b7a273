// The time loop: where it stops, whom it tells, and what a failing step leaves.
#include "solver/run/loop.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "base/errors.hpp"

namespace crawford {

namespace {

/// A slab that heats up, 5 steps and a bit.
Scene slab() {
    Scene scene;
    scene.domain = {.width = 5e-6, .depth = 100e-6, .nx = 1, .ny = 16};
    scene.physics = {.mechanics = false, .reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {1e6};
    scene.time.step = 1e-5;
    scene.time.end = 5.5e-5;
    return scene;
}

TEST(Loop, PassesAnEndThatIsNoMultipleOfTheStepByTheLeastThatCoversIt) {
    Simulation simulation(slab());
    run_to_end(simulation);
    EXPECT_EQ(simulation.state().step, 6);
    EXPECT_EQ(simulation.state().time, 6 * 1e-5);
    run_to_end(simulation);
    EXPECT_EQ(simulation.state().step, 6) << "it is there already";
}

TEST(Loop, CountsStepsFromWhereItStands) {
    Simulation simulation(slab());
    run_steps(simulation, 2);
    run_steps(simulation, 3);
    EXPECT_EQ(simulation.state().step, 5);
    EXPECT_EQ(simulation.state().time, 5 * 1e-5);
}

TEST(Loop, StopsWhereTheCallerSays) {
    Simulation simulation(slab());
    run_until(simulation, [](const Simulation& s) { return s.state().temperature(0, 16) > 300.0; });
    EXPECT_EQ(simulation.state().step, 1);
}

TEST(Loop, TellsAllObserversOfEachStepInTheirOrder) {
    Simulation simulation(slab());
    std::vector<int> told;
    std::vector<double> began;
    const Observer first = [&](Simulation&, double before) {
        told.push_back(1);
        began.push_back(before);
    };
    const Observer second = [&](Simulation&, double) { told.push_back(2); };
    run_steps(simulation, 2, {first, second});
    EXPECT_EQ(told, (std::vector{1, 2, 1, 2}));
    EXPECT_EQ(began, (std::vector{0.0, 1e-5}));
}

TEST(Loop, LeavesTheStateWholeWhereAStepFails) {
    Sources sources;
    sources.heat = [](double, double, double t) {
        return t > 2.2e-5 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    };
    Simulation simulation(slab(), sources);
    int told = 0;
    const Observer count = [&](Simulation&, double) { ++told; };
    EXPECT_THROW(run_to_end(simulation, {count}), NumericalFailure);
    EXPECT_EQ(told, 2) << "nobody is told of a step that failed";
    EXPECT_EQ(simulation.state().step, 2);
    EXPECT_EQ(simulation.state().time, 2 * 1e-5);
    for (const double temperature : simulation.state().temperature.values())
        EXPECT_GE(temperature, 300.0 - 1e-9);
}

}  // namespace

}  // namespace crawford
