// Heat and surface each step, the solid every so many.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/step/simulation.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

Scene in_turns(int every) {
    Scene scene = testing::sandwich(16, 24);
    scene.surface.pressure = 2e6;
    scene.time.mechanics_every = every;
    return scene;
}

/// A disc comes to the surface, so that cells change their material.
Scene with_a_disc(int every) {
    Scene scene = in_turns(every);
    scene.morphology.shape = Discs{.discs = {{1e-6, -5e-6, 60e-6}}, .period = 1.0};
    scene.physics.regression = Regression::fixed;
    scene.surface.burn_rate = 0.5e-2;
    return scene;
}

template <class Field>
double distance(const Field& a, const Field& b) {
    double sum = 0.0;
    double size = 0.0;
    for (size_t k = 0; k < a.values().size(); ++k) {
        sum += std::pow(a.values()[k] - b.values()[k], 2);
        size += std::pow(b.values()[k], 2);
    }
    return std::sqrt(sum / size);
}

State after(const Scene& scene, int steps) {
    Simulation simulation(scene);
    run_steps(simulation, steps);
    return simulation.state();
}

TEST(Turns, HoldTheSolidBetween) {
    Simulation simulation(in_turns(4));
    run_steps(simulation, 8);
    const State moved = simulation.state();
    EXPECT_FALSE(moved.previous);
    for (const long step : {9, 10, 11}) {
        run_steps(simulation, 1);
        const State& now = simulation.state();
        EXPECT_EQ(now.velocity.values(), moved.velocity.values());
        EXPECT_EQ(now.stress.pressure.values(), moved.stress.pressure.values());
        EXPECT_EQ(now.reference_shift.values(), moved.reference_shift.values());
        EXPECT_NE(now.temperature.values(), moved.temperature.values()) << "heat goes on";
        EXPECT_LT(simulation.summary().residual, 1e-12) << "in equilibrium where it stands";
        ASSERT_TRUE(now.previous);
        EXPECT_EQ(now.step, step);
        EXPECT_EQ(now.previous->step, 8);
        EXPECT_FALSE(now.previous->previous) << "no chain of states";
    }
    run_steps(simulation, 1);
    EXPECT_NE(simulation.state().velocity.values(), moved.velocity.values());
    EXPECT_FALSE(simulation.state().previous);
}

// First order in the step, as the step that holds nothing is.
TEST(Turns, ErrByHalfInHalfTheStep) {
    const auto error = [](int every, double step) {
        Scene held = in_turns(every), plain = in_turns(1);
        held.time.step = plain.time.step = step;
        const int steps = int(std::lround(3.2e-3 / step));
        return distance(after(held, steps).stress.pressure, after(plain, steps).stress.pressure);
    };
    for (const int every : {2, 4}) {
        const double coarse = error(every, 40e-6), fine = error(every, 20e-6);
        EXPECT_LT(coarse, 0.01);
        EXPECT_NEAR(coarse / fine, 2.0, 0.2) << every;
    }
}

TEST(Turns, CarryWhatADiscHolds) {
    const State plain = after(with_a_disc(1), 40);
    const State two = after(with_a_disc(2), 40), four = after(with_a_disc(4), 40);
    // 0.0054 and 0.016; cells softened by what they became in the last step alone: 0.0091 and 0.024.
    EXPECT_LT(distance(two.stress.pressure, plain.stress.pressure), 0.007);
    EXPECT_LT(distance(four.stress.pressure, plain.stress.pressure), 0.02);
}

TEST(Turns, GoOnBitForBitFromBetween) {
    for (const Scene& scene : {in_turns(4), with_a_disc(4)}) {
        Simulation unbroken(scene);
        run_steps(unbroken, 6);
        Simulation restarted(scene);
        restarted.restore(unbroken.state());
        EXPECT_EQ(restarted.summary().residual, unbroken.summary().residual);
        run_steps(unbroken, 7);
        run_steps(restarted, 7);
        EXPECT_EQ(restarted.state().surface, unbroken.state().surface);
        EXPECT_EQ(restarted.state().velocity.values(), unbroken.state().velocity.values());
        EXPECT_EQ(restarted.state().stress.pressure.values(),
                  unbroken.state().stress.pressure.values());
    }
}

TEST(Turns, DoNotGoOnFromBetweenWithoutTheSolidThatWasMoved) {
    State state = after(in_turns(4), 6);
    state.previous.reset();
    Simulation simulation(in_turns(4));
    EXPECT_THROW(simulation.restore(state), InputError);
    EXPECT_THROW(Simulation(in_turns(1)).restore(after(in_turns(4), 6)), InputError);
}

TEST(Turns, SayWhatIsTooLong) {
    Scene scene = with_a_disc(50);
    try {
        after(scene, 100);
        FAIL() << "50 steps of the solid's are two rows";
    } catch (const NumericalFailure& failure) {
        EXPECT_THAT(failure.what(), ::testing::HasSubstr("reduce time.mechanics_every"));
    }
}

TEST(Turns, AreForetoldToBeTooLong) {
    const auto crossing = [](int every) {
        Scene scene = in_turns(every);
        scene.time.step = 40e-6;
        const Guards guards = predicted(scene);
        return *std::ranges::find(guards, "crossing_y", &Guard::name);
    };
    const Guard plain = crossing(1), long_turns = crossing(80);
    EXPECT_EQ(plain.beyond, Beyond::nothing);
    EXPECT_NEAR(long_turns.value, 80.0 * plain.value, 1e-12);
    EXPECT_EQ(long_turns.beyond, Beyond::refusal);
    EXPECT_THAT(long_turns.text, ::testing::HasSubstr("time.mechanics_every"));
    EXPECT_NEAR(*long_turns.longest_step, 40e-6 / long_turns.value, 1e-18) << "of heat's";
}

TEST(Turns, AreRefusedWhereTheyCannotBe) {
    const auto refusal = [](const auto& change) -> std::string {
        Scene scene = in_turns(4);
        change(scene);
        try {
            check(scene);
        } catch (const InputError& problem) {
            return problem.what();
        }
        return "taken";
    };
    EXPECT_EQ(refusal([](Scene&) {}), "taken");
    EXPECT_THAT(refusal([](Scene& s) { s.time.scheme = Stepping::bdf2; }),
                ::testing::HasSubstr("time.mechanics_every = 4 needs time.scheme = \"euler\""));
    EXPECT_THAT(refusal([](Scene& s) { s.time.accuracy = 1e-3; }),
                ::testing::HasSubstr("a time.step that is given"));
    EXPECT_THAT(refusal([](Scene& s) { s.physics.mechanics = s.physics.reference_map = false; }),
                ::testing::HasSubstr("needs physics.mechanics = true"));
    EXPECT_THAT(refusal([](Scene& s) { s.morphology.indicator = Indicator::reference_map; }),
                ::testing::HasSubstr("needs morphology.indicator"));
}

}  // namespace
}  // namespace crawford
