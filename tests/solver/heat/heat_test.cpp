#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.hpp"
#include "solver/heat/heat_step.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

/// Largest error of a quarter wave that decays in a solid at rest, held cold at the bottom and
/// insulated above.
double decay_error(int ny, double dt) {
    Scene scene = testing::slab(ammonium_perchlorate(), ny);
    scene.physics = {
        .heat = true, .mechanics = false, .reference_map = false, .regression = Regression::none};
    scene.domain.clustering = 1.0;
    scene.surface.heat_flux = {0.0};
    scene.time.step = dt;
    Simulation simulation(scene);
    State state = simulation.state();
    const double wave_number = 0.5 * std::numbers::pi / scene.domain.depth;
    const auto shape = [&](int j) {
        return std::sin(wave_number * (simulation.grid().eta(j) + scene.domain.depth));
    };
    for (int j = 0; j <= ny; ++j) state.temperature(0, j) = 300.0 + 100.0 * shape(j);
    simulation.restore(state);
    const double end = 0.1;
    while (simulation.state().time < end - 0.5 * dt) run_steps(simulation, 1);
    const double diffusivity = 0.405 / (1950.0 * 1255.2);
    const double decay = std::exp(-diffusivity * wave_number * wave_number * end);
    double worst = 0.0;
    for (int j = 0; j <= ny; ++j)
        worst = std::max(worst, std::abs(simulation.state().temperature(0, j) - 300.0 -
                                         100.0 * decay * shape(j)));
    return worst;
}

TEST(Heat, IsOfSecondOrderInSpaceAndTime) {
    // Halving h and dt together quarters the error; 3.8 leaves room for the next term of the
    // expansion.
    const double coarse = decay_error(32, 4e-3);
    const double fine = decay_error(64, 2e-3);
    EXPECT_GT(coarse / fine, 3.8);
    EXPECT_LT(coarse / fine, 4.2);
    EXPECT_LT(fine, 0.02);  // [K] of 100; measured 0.005
}

TEST(Heat, ALongStepFindsTheBurnRateOfAShortOne) {
    // Pyrolysis absorbs heat; taken at the old temperature it overshoots beyond 0.11 ms on this
    // grid and the slab burns on at a wrong rate. The steady state does not depend on the step.
    const auto steady_rate = [](double dt) {
        Scene scene = testing::slab(ammonium_perchlorate(), 96);
        scene.domain.clustering = 2.0;
        scene.morphology.materials = {ammonium_perchlorate()};
        scene.physics = {.heat = true, .mechanics = false, .reference_map = false};
        scene.surface.heat_flux = {8.368e6};
        scene.time.step = dt;
        Simulation simulation(scene);
        while (simulation.state().time < 0.4) run_steps(simulation, 1);
        return simulation.summary().mean_burn_rate;
    };
    const double exact = steady_rate(20e-6);
    EXPECT_NEAR(steady_rate(160e-6), exact, 1e-6 * exact);
}

TEST(Heat, ALongStepForFineCellsDampsAZigzag) {
    // A zigzag along the columns, alone: after each step at most 0.9 of it is left, not all of it
    // as with Crank-Nicolson.
    Scene scene = testing::slab(ammonium_perchlorate(), 64);
    scene.physics = {.mechanics = false, .reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {0.0};
    scene.time.step = 10e-3;  // 4 D dt/h^2 = 117
    Simulation simulation(scene);
    State state = simulation.state();
    for (int j = 1; j < 64; ++j) state.temperature(0, j) += j % 2 == 0 ? 1.0 : -1.0;
    simulation.restore(state);
    run_steps(simulation, 10);
    double largest = 0.0;
    for (int j = 1; j < 64; ++j)
        largest = std::max(largest, std::abs(simulation.state().temperature(0, j) - 300.0));
    EXPECT_LT(largest, 0.5);  // 0.9^10 = 0.35; with Crank-Nicolson 0.7
}

TEST(Heat, ALevelSurfaceStaysLevelAndASymmetricSandwichSymmetric) {
    Scene scene = testing::sandwich(16, 24);
    scene.physics.mechanics = scene.physics.reference_map = false;
    Simulation simulation(scene);
    for (int k = 0; k < 300; ++k) run_steps(simulation, 1);
    const State& s = simulation.state();
    for (int i = 1; i < 8; ++i)
        EXPECT_NEAR(s.temperature(8 - i, 24), s.temperature(8 + i, 24), 1e-6) << i;
    EXPECT_GT(s.temperature(0, 24), 800.0);
}

TEST(Heat, LaggedCouplingBeyondItsLimitIsRefusedAndTheLastGoodStateKept) {
    // Lagged coupling beyond g = T beta^2/(rho c_p P) = 1: alpha x 1.6 makes g above 1 from about
    // 470 K on.
    Material binder = htpb_binder();
    binder.thermal_expansion *= 1.6;
    Scene scene = testing::slab(binder, 48);
    scene.numerics.coupling = Coupling::lagged;
    Simulation simulation(scene);
    try {
        for (int k = 0; k < 20000; ++k) run_steps(simulation, 1);
        FAIL() << "lagged coupling beyond g = 1 did not diverge";
    } catch (const NumericalFailure& failure) {
        const std::string said = failure.what();
        EXPECT_NE(said.find("step "), std::string::npos) << said;
        EXPECT_NE(said.find("heat"), std::string::npos) << said;
        EXPECT_NE(said.find("cell (0, "), std::string::npos) << said;
    }
    for (const double t : simulation.state().temperature.values()) EXPECT_GT(t, 0.0);
}

TEST(Heat, TheAdiabaticSplitHoldsWhereTheLaggedCouplingDiverges) {
    Material binder = htpb_binder();
    binder.thermal_expansion *= 1.6;
    Simulation simulation(testing::slab(binder, 48));
    for (int k = 0; k < 20000; ++k) run_steps(simulation, 1);
    EXPECT_GT(simulation.summary().largest_temperature, 500.0);
    EXPECT_LT(simulation.summary().largest_temperature, 1100.0);
}

}  // namespace
}  // namespace crawford
