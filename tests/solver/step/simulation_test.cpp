#include "solver/step/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/run/loop.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

void expect_identical(const State& a, const State& b) {
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.temperature.values(), b.temperature.values());
    EXPECT_EQ(a.stress.pressure.values(), b.stress.pressure.values());
    EXPECT_EQ(a.velocity.values(), b.velocity.values());
    EXPECT_EQ(a.reference_shift.values(), b.reference_shift.values());
}

/// In series, of what each cell holds now.
CellField shear_modulus(const Simulation& simulation) {
    const auto& materials = simulation.scene().morphology.materials;
    CellField mu = simulation.material_fraction();
    for (double& f : mu.values())
        f = 1.0 / (f / materials[0].shear_modulus + (1.0 - f) / materials[1].shear_modulus);
    return mu;
}

TEST(Simulation, GoesOnFromAStateBitForBit) {
    const Scene scene = testing::sandwich(16, 24);
    Simulation unbroken(scene);
    for (int k = 0; k < 10; ++k) run_steps(unbroken, 1);
    Simulation restarted(scene);
    restarted.restore(unbroken.state());
    for (int k = 0; k < 10; ++k) {
        run_steps(unbroken, 1);
        run_steps(restarted, 1);
    }
    expect_identical(unbroken.state(), restarted.state());
}

TEST(Simulation, GoesOnBitForBitWhereTheStepLooksBack) {
    Scene scene = testing::sandwich(16, 24);
    scene.time.scheme = Stepping::bdf2;
    Simulation unbroken(scene);
    for (int k = 0; k < 5; ++k) run_steps(unbroken, 1);
    ASSERT_TRUE(unbroken.state().previous);
    EXPECT_EQ(unbroken.state().previous->step, 4);
    EXPECT_FALSE(unbroken.state().previous->previous) << "no chain of states";
    Simulation restarted(scene);
    restarted.restore(unbroken.state());
    for (int k = 0; k < 5; ++k) {
        run_steps(unbroken, 1);
        run_steps(restarted, 1);
    }
    expect_identical(unbroken.state(), restarted.state());
}

/// What it looks back at is as soft as the material has become since, or the difference of the two
/// would take off what a softened cell still holds.
TEST(Simulation, RemembersStressInTheMaterialOfNow) {
    Scene scene = testing::sandwich(16, 24);
    scene.morphology.shape = Discs{.discs = {{1e-6, 0.0, 60e-6}}, .period = 1.0};
    scene.physics.regression = Regression::fixed;
    scene.surface.burn_rate = 0.5e-2;
    scene.surface.pressure = 2e6;
    scene.time.scheme = Stepping::bdf2;
    scene.time.step = 100e-6;
    Simulation simulation(scene);
    run_steps(simulation, 10);
    const StressField before = simulation.state().stress;
    const CellField was = shear_modulus(simulation);
    run_steps(simulation, 1);
    const CellField is = shear_modulus(simulation);
    const StressField& remembered = simulation.state().previous->stress;
    int softer = 0;
    for (size_t k = 0; k < is.values().size(); ++k) {
        const double ratio = std::min(is.values()[k] / was.values()[k], 1.0);
        softer += ratio < 0.99 ? 1 : 0;
        const double held = before.deviator[0].values()[k].s22;
        EXPECT_NEAR(remembered.deviator[0].values()[k].s22, ratio * held, 1e-9 * std::abs(held));
    }
    EXPECT_GT(softer, 5) << "or nothing was shown";
}

TEST(Simulation, WithOneStepRefusesAStateThatLooksBack) {
    Scene scene = testing::sandwich(16, 24);
    Simulation one_step(scene);
    scene.time.scheme = Stepping::bdf2;
    Simulation two_step(scene);
    run_steps(two_step, 1);
    EXPECT_THROW(one_step.restore(two_step.state()), InputError);
}

TEST(Simulation, RefusesAStateOfAnotherScene) {
    Simulation coarse(testing::sandwich(16, 24));
    Simulation fine(testing::sandwich(32, 24));
    EXPECT_THROW(fine.restore(coarse.state()), InputError);
}

TEST(Simulation, HalfOfASymmetricSandwichIsHalfOfTheWhole) {
    Scene scene = testing::sandwich(16, 24);
    Simulation whole(scene);
    scene.domain.half = true;
    Simulation half(scene);
    for (int k = 0; k < 150; ++k) {
        run_steps(whole, 1);
        run_steps(half, 1);
    }
    // The same discrete equations: only the order of sums and the last sweep of the line relaxation
    // differ.
    for (int i = 0; i <= 8; ++i) {
        const int mirror = (i + 8) % 16;
        EXPECT_NEAR(half.state().temperature(i, 24), whole.state().temperature(mirror, 24), 1e-5)
            << i;
        EXPECT_NEAR(half.state().velocity(i, 24).y(), whole.state().velocity(mirror, 24).y(), 1e-9)
            << i;
        EXPECT_NEAR(half.state().surface[size_t(i)], whole.state().surface[size_t(mirror)], 1e-14)
            << i;
    }
}

TEST(Simulation, AllocatesOnlyWhatTheSceneAsksFor) {
    Scene thermal = testing::sandwich(8, 12);
    thermal.physics.mechanics = thermal.physics.reference_map = false;
    const Simulation cool(thermal);
    EXPECT_TRUE(cool.state().stress.empty());
    EXPECT_TRUE(cool.state().velocity.empty());
    const Simulation cold(testing::mechanical_only(testing::sandwich(8, 12)));
    EXPECT_TRUE(cold.state().temperature.empty());
    EXPECT_TRUE(cold.state().reference_shift.empty());
}

TEST(Simulation, StopsWhereTheStepIsBeyondItsLimit) {
    Scene scene = testing::slab(ammonium_perchlorate(), 64);  // cells of 7.5 um
    scene.time.step = 2e-3;                                   // and 9 um burnt a step
    Simulation simulation(scene);
    try {
        run_steps(simulation, 1);
        FAIL() << "the material crossed more than a cell";
    } catch (const NumericalFailure& failure) {
        const std::string said = failure.what();
        EXPECT_NE(said.find("step 1"), std::string::npos) << said;
        EXPECT_NE(said.find("stress"), std::string::npos) << said;
        EXPECT_NE(said.find("cell (0, "), std::string::npos) << said;
    }
    EXPECT_EQ(simulation.state().step, 0);
}

TEST(Simulation, NamesTheCellWhoseStressNoNumberHolds) {
    // sigma11 may take any value in a slab without the solid moving: 1.2e308 Pa in one cell still
    // balances, but the sum over its four points is beyond the largest double, 1.8e308.
    Scene scene = testing::mechanical_only(testing::slab(ammonium_perchlorate(), 16));
    scene.time.step = 1.0;
    const Grid grid(scene.domain);
    Sources sources;
    sources.stress = [&](double, double y, double) {
        const bool there = y > grid.eta(8) && y < grid.eta(9);
        return PlaneStress{.s11 = there ? 1.2e308 : 0.0};
    };
    Simulation simulation(scene, sources);
    try {
        run_steps(simulation, 1);
        FAIL() << "a stress that no number holds went unseen";
    } catch (const NumericalFailure& failure) {
        const std::string said = failure.what();
        EXPECT_NE(said.find("stress"), std::string::npos) << said;
        EXPECT_NE(said.find("cell (0, 8)"), std::string::npos) << said;
    }
    EXPECT_EQ(simulation.state().step, 0);
}

TEST(Simulation, HeatsByASourceAsByItsIntegral) {
    // A uniform source in an insulated solid at rest: rho c_p dT/dt = q, away from the held bottom.
    Scene scene = testing::slab(ammonium_perchlorate(), 16);
    scene.physics = {
        .heat = true, .mechanics = false, .reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {0.0};
    scene.time.step = 1e-4;
    Simulation simulation(
        scene, {{.heat = [](double, double, double) { return 1950.0 * 1255.2 * 1e3; }}, {}, {}});
    run_steps(simulation, 10);
    EXPECT_NEAR(simulation.state().temperature(0, 16), 301.0, 1e-6);
}

TEST(Simulation, ABodyForceHangsOnTheBottom) {
    // b = -g in a confined slab without load: sigma22 = g y below the surface, at the cells'
    // centres.
    Scene scene = testing::mechanical_only(testing::slab(ammonium_perchlorate(), 16));
    scene.surface.pressure = 0.0;
    Simulation simulation(
        scene, {{}, {}, {.body_force = [](double, double, double) { return Vector(0.0, -1e9); }}});
    run_steps(simulation, 1);
    const Grid& grid = simulation.grid();
    for (int j = 0; j < 16; ++j)
        EXPECT_NEAR(simulation.state().stress.mean(0, j).s22,
                    1e9 * 0.5 * (grid.eta(j) + grid.eta(j + 1)), 1e-3);
}

TEST(Simulation, AStressSourceRaisesTheStressItIsGivenFor) {
    Scene scene = testing::mechanical_only(testing::slab(ammonium_perchlorate(), 16));
    scene.surface.pressure = 0.0;
    const PlaneStress source{3e9, 0.0, 3e9, 0.0};  // [Pa/s], in equilibrium as it is
    Simulation simulation(scene,
                          {{}, {.stress = [=](double, double, double) { return source; }}, {}});
    run_steps(simulation, 1);
    EXPECT_NEAR(simulation.state().stress.mean(0, 8).s11, 3e9 * scene.time.step, 1e-3);
    EXPECT_NEAR(simulation.state().stress.mean(0, 8).s22, 0.0, 1e-3);
}

}  // namespace
}  // namespace crawford
