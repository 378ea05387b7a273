// Steps that are as long as their error allows.
#include "solver/run/chosen_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/errors.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/run/burn.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"
#include "solver/time_integration/time_step.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {
namespace {

/// A rigid slab of AP that is set alight.
Scene rigid_slab() {
    Scene scene = testing::slab(ammonium_perchlorate(), 48);
    scene.domain.clustering = 2.0;
    scene.physics = {
        .mechanics = false, .reference_map = false, .regression = Regression::pyrolysis};
    scene.surface.heat_flux = {8.368e6};
    scene.time = {.step = first_chosen_step, .accuracy = 1e-3, .end = 20e-3};
    return scene;
}

Scene coupled_sandwich(Stepping scheme) {
    Scene scene = testing::sandwich(16, 24);
    scene.domain.half = true;
    scene.time = {.step = first_chosen_step,
                  .accuracy = 1e-3,
                  .end = 4e-3,
                  .until_steady = {},
                  .scheme = scheme};
    return scene;
}

/// The most of what is crossed in any step of a run.
double most_crossed(const Scene& scene, double Crossed::*what) {
    Simulation simulation(scene);
    const Crossing crossing(scene, simulation.grid());
    SurfaceField before = simulation.state().surface;
    double most = 0.0;
    run_to_end(simulation, {[&](const Simulation& now, double) {
                   most = std::max(most, crossing.of(before, now.state()).*what);
                   before = now.state().surface;
               }});
    return most;
}

TEST(TwoStepWeights, AreExactForAParabolaWhateverTheLengths) {
    const auto y = [](double t) { return 1.0 + 2.0 * t + 3.0 * t * t; };
    const auto slope = [](double t) { return 2.0 + 6.0 * t; };
    for (const double ratio : {0.3, 1.0, 2.0}) {
        const double before = 0.4, dt = ratio * before;
        const TwoStepWeights w = bdf2_weights(ratio);
        EXPECT_NEAR(w.of_now * y(0.0) - w.of_before * y(-before) + w.of_span * dt * slope(dt),
                    y(dt), 1e-14);
    }
    EXPECT_EQ(bdf2_weights(1.0).of_now, 4.0 / 3.0) << "equal steps: bit for bit the usual ones";
    EXPECT_EQ(bdf2_step(0.0, 20e-6, 1.0).span, 2.0 / 3.0 * 20e-6);
}

TEST(ChosenSteps, EndAtTheTimesThatAreAskedForAndNowhereElse) {
    Scene scene = rigid_slab();
    scene.output.snapshots_every = 3e-3;
    Simulation simulation(scene);
    std::vector<double> times;
    run_to_end(simulation, {[&](const Simulation& s, double) { times.push_back(s.state().time); }});
    EXPECT_EQ(times.back(), scene.time.end);
    for (int k = 1; k <= 6; ++k) EXPECT_EQ(std::ranges::count(times, k * 3e-3), 1) << k;
    Scene more = scene;
    more.output.checkpoint_every = 1e-3;
    Simulation other(more);
    run_to_end(other);
    EXPECT_EQ(other.state().step, simulation.state().step) << "checkpoints shorten none";
    EXPECT_EQ(other.state().temperature.values(), simulation.state().temperature.values());
}

TEST(ChosenSteps, BurnAsShortEqualOnesDo) {
    Scene scene = rigid_slab();
    Simulation chosen(scene);
    run_to_end(chosen);
    scene.time.accuracy.reset();
    scene.time.step = 2e-6;
    Simulation equal(scene);
    run_to_end(equal);
    EXPECT_LT(chosen.state().step, 400) << "of 10,000";
    EXPECT_NEAR(chosen.state().time, equal.state().time, 1e-12);
    EXPECT_NEAR(chosen.summary().mean_burn_rate / equal.summary().mean_burn_rate, 1.0, 1e-3);
    // What is missed while the rate settles stays in the depth: first order in the step.
    EXPECT_NEAR(chosen.state().surface[0] / equal.state().surface[0], 1.0, 1e-2);
}

TEST(ChosenSteps, AreTriedAgainShorterWhereOneFails) {
    // The material crosses a cell of 2.5 um in some 0.6 ms.
    Scene scene = testing::slab(ammonium_perchlorate(), 192);
    scene.physics.reference_map = false;
    scene.time = {.step = 1e-3, .end = 20e-3};
    Simulation equal(scene);
    EXPECT_THROW(run_to_end(equal), NumericalFailure) << "or nothing fails here";
    scene.time.accuracy = 0.1;
    Simulation simulation(scene);
    ChosenSteps steps(simulation.scene(), simulation.grid());
    while (!steps.at_the_end(simulation.state())) steps.advance(simulation);
    EXPECT_GT(steps.choice()->count.failed, 0);
    EXPECT_LT(steps.choice()->count.failed, simulation.state().step);
    EXPECT_LT(steps.choice()->count.longest, 0.6e-3);
}

TEST(ChosenSteps, CrossNoMoreThanARow) {
    Scene scene = rigid_slab();  // nothing fails where stress is not carried
    scene.time.accuracy = 0.1;
    const double most = most_crossed(scene, &Crossed::rows);
    EXPECT_GT(most, 0.7) << "or nothing held them";
    EXPECT_LE(most, 1.0);
}

// Narrow columns at the steep side of a strip: V was 10 % off without a failure.
TEST(ChosenSteps, LetNoWaveOfTheSurfaceRunTooFar) {
    Scene scene = testing::sandwich(32, 48);
    scene.domain.half = true;
    scene.domain.clustering_x = 2.0;
    scene.physics = {.mechanics = false, .reference_map = false};
    scene.time = {.step = first_chosen_step, .accuracy = 1e-2, .end = 50e-3};
    const double most = most_crossed(scene, &Crossed::by_front);
    EXPECT_GT(most, 0.6) << "or nothing held them";
    EXPECT_LE(most, 0.9);
}

TEST(ChosenSteps, FollowAFlameThatSwings) {
    Scene scene = rigid_slab();
    scene.surface.modulation = FluxModulation{.amplitude = 1e-6, .frequency = 1000.0};
    Simulation simulation(scene);
    double longest = 0.0;
    run_to_end(simulation, {[&](const Simulation& now, double before) {
                   longest = std::max(longest, now.state().time - before);
               }});
    EXPECT_GT(longest, 40e-6);
    EXPECT_LE(longest, 50e-6 * (1.0 + 1e-9)) << "a twentieth of a period";
}

TEST(ChosenSteps, FailInTheEndWhereNoStepIsShortEnough) {
    Scene scene = rigid_slab();
    scene.surface.heat_flux = {std::numeric_limits<double>::quiet_NaN()};
    Simulation simulation(scene);
    EXPECT_THROW(run_to_end(simulation), NumericalFailure);
    EXPECT_EQ(simulation.state().step, 0);
}

class ChosenStepsBurn : public OutputTest {
protected:
    static Checkpoint load(const std::filesystem::path& file, const Scene& scene) {
        return load_checkpoint(file, to_toml(scene));
    }
    static void expect_same(const Checkpoint& a, const Checkpoint& b) {
        EXPECT_TRUE(a.state.time == b.state.time && a.state.length == b.state.length);
        EXPECT_TRUE(a.state.surface == b.state.surface);
        EXPECT_TRUE(a.state.temperature.values() == b.state.temperature.values());
        EXPECT_TRUE(a.state.stress.pressure.values() == b.state.stress.pressure.values());
        EXPECT_TRUE(a.memory.choice->next == b.memory.choice->next);
        EXPECT_TRUE(a.memory.choice->memory.slope == b.memory.choice->memory.slope);
    }
};

TEST_F(ChosenStepsBurn, GoOnFromACheckpointBitForBit) {
    for (const Stepping scheme : {Stepping::euler, Stepping::bdf2}) {
        Scene scene = coupled_sandwich(scheme);
        scene.output.checkpoint_every = 1.5e-3;
        const BurnOptions whole{.name = "run", .directory = directory / "whole"};
        const long last = burn(scene, whole).step;
        std::vector<std::filesystem::path> checkpoints;
        for (const auto& file : std::filesystem::directory_iterator(directory / "whole"))
            if (file.path().string().find("checkpoint") != std::string::npos)
                checkpoints.push_back(file.path());
        std::ranges::sort(checkpoints);
        ASSERT_EQ(checkpoints.size(), 3U);
        const BurnOutcome rest =
            burn(scene,
                 {.name = "run", .directory = directory / "rest", .restart = checkpoints.front()});
        EXPECT_EQ(rest.step, last);
        expect_same(load(rest.checkpoint, scene), load(checkpoints.back(), scene));
        const auto manifest = nlohmann::json::parse(content(directory / "rest" / "manifest.json"));
        EXPECT_GT(manifest.at("steps").at("longest_seconds"), first_chosen_step);
        std::filesystem::remove_all(directory / "whole");
        std::filesystem::remove_all(directory / "rest");
    }
}

TEST(ChosenSteps, AreAskedForInAScene) {
    const std::string scene =
        "title = \"s\"\n[domain]\nwidth = \"10 um\"\ndepth = \"100 um\"\nnx = 1\nny = 8\n"
        "[morphology]\nkind = \"uniform\"\nmaterial = \"AP\"\n[physics]\nmechanics = false\n"
        "reference_map = false\n[surface]\n"
        "heat_flux = { AP = \"100 cal/(s cm2)\" }\n[time]\nend = \"1 ms\"\n";
    const Scene plain = parse_scene(scene + "step = \"auto\"\n");
    EXPECT_EQ(plain.time.accuracy, default_accuracy);
    const Scene fine = parse_scene(scene + "step = \"auto\"\naccuracy = 1e-4\n");
    EXPECT_EQ(fine.time.accuracy, 1e-4);
    EXPECT_EQ(to_toml(parse_scene(to_toml(fine))), to_toml(fine));
    EXPECT_NE(to_toml(fine).find("step = \"auto\""), std::string::npos);
    EXPECT_THROW(parse_scene(scene + "step = \"20 us\"\naccuracy = 1e-4\n"), InputError);
    EXPECT_THROW(parse_scene(scene + "step = \"automatic\"\n"), InputError);
    EXPECT_THROW(parse_scene(scene + "step = \"auto\"\naccuracy = 0.5\n"), InputError);
}

}  // namespace
}  // namespace crawford
