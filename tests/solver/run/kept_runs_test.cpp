/// A run is known by what is burnt, not by what is written of it.
#include "solver/run/kept_runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/scratch.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/run/run_identity.hpp"
#include "tests/solver/scene/scene_text.hpp"

namespace crawford {
namespace {

/// A sandwich, stress and all, that burns eight steps.
Scene small_scene(double checkpoint_every) {
    Scene scene = testing::with({"title=small", "domain.nx=8", "domain.ny=8", "time.end=160 us"});
    scene.output.checkpoint_every = checkpoint_every;
    return scene;
}

class KeptRunsTest : public ::testing::Test {
protected:
    /// How often the run was told to go on while it was fetched: 0 if it was there.
    int steps_to_get(const Scene& scene) {
        int steps = 0;
        runs_.get(scene, [&](double) { ++steps; });
        return steps;
    }

    Scratch scratch_;
    KeptRuns runs_{scratch_.path()};
};

TEST_F(KeptRunsTest, AreMadeOnceWhateverTheirTitle) {
    Scene scene = small_scene(80e-6);
    EXPECT_FALSE(runs_.has(scene));
    EXPECT_EQ(steps_to_get(scene), 8);
    EXPECT_TRUE(runs_.has(scene));
    scene.title = "another";
    EXPECT_EQ(steps_to_get(scene), 0);
}

TEST_F(KeptRunsTest, OfOtherPhysicsNumericsOrEndAreOthers) {
    const Scene scene = small_scene(80e-6);
    runs_.get(scene);
    Scene other = scene;
    other.bottom.temperature = 301.0;
    EXPECT_FALSE(runs_.has(other));
    other = scene;
    other.numerics.heat_tolerance *= 2.0;
    EXPECT_FALSE(runs_.has(other));
    other = scene;
    other.time.end *= 2.0;
    EXPECT_FALSE(runs_.has(other));
}

TEST_F(KeptRunsTest, ServeWhoAsksForLessAndAreMadeAgainForMore) {
    const Scene fine = small_scene(20e-6);
    const Scene coarse = small_scene(40e-6);
    const auto first = runs_.get(coarse);
    EXPECT_THROW(first->at(20e-6), InputError);
    EXPECT_FALSE(runs_.has(fine));
    EXPECT_EQ(steps_to_get(fine), 8);
    EXPECT_TRUE(runs_.has(coarse)) << "what it had it has still";
    const auto second = runs_.get(coarse);
    EXPECT_EQ(second->mean_burn_rate, first->mean_burn_rate) << "the same bits";
    EXPECT_DOUBLE_EQ(second->at(20e-6).time, 20e-6);
}

TEST_F(KeptRunsTest, OfUnequalIntervalsAreMadeWithBoth) {
    runs_.get(small_scene(40e-6));
    runs_.get(small_scene(60e-6));
    EXPECT_TRUE(runs_.has(small_scene(40e-6)));
    EXPECT_TRUE(runs_.has(small_scene(60e-6)));
}

TEST_F(KeptRunsTest, ThatAreDamagedAreMadeAnew) {
    const Scene scene = small_scene(80e-6);
    const auto run = runs_.get(scene);
    const auto file = run->directory / "manifest.json";
    std::filesystem::remove(file);
    EXPECT_EQ(steps_to_get(scene), 8);
    for (const char* member : {"scene", "outcome", "last_step", "solver_fingerprint"}) {
        auto manifest = nlohmann::ordered_json::parse(std::ifstream(file));
        manifest[member] = {1, 2};
        std::ofstream(file) << manifest.dump(2);
        EXPECT_EQ(steps_to_get(scene), 8) << member;
    }
}

/// Marks a run as cut off.
void cut_off(const std::filesystem::path& directory) {
    const auto file = directory / "manifest.json";
    auto manifest = nlohmann::ordered_json::parse(std::ifstream(file));
    manifest["outcome"] = "running";
    std::ofstream(file) << manifest.dump(2);
}

TEST_F(KeptRunsTest, WhoseLastCheckpointIsDamagedGoOnFromTheOneBefore) {
    const Scene scene = small_scene(20e-6);
    const auto run = runs_.get(scene);
    ASSERT_EQ(run->time.size(), 8U);
    const auto last = checkpoint_file(run->directory, "burn", 7);
    const auto size = std::filesystem::file_size(last);
    cut_off(run->directory);
    EXPECT_EQ(steps_to_get(scene), 1);
    cut_off(run->directory);
    std::fstream(last, std::ios::in | std::ios::out | std::ios::binary).seekp(long(size / 2))
        << "??";
    EXPECT_EQ(steps_to_get(scene), 2);
    cut_off(run->directory);
    std::filesystem::resize_file(last, size - 1);
    EXPECT_EQ(steps_to_get(scene), 2);
    EXPECT_EQ(runs_.get(scene)->mean_burn_rate, run->mean_burn_rate);
}

TEST_F(KeptRunsTest, ThatFailedAreTriedAgainFromTheirLastCheckpoint) {
    Scene scene = small_scene(80e-6);
    // Crosses 1.2 rows of 15 um in a step: not so far beyond the limit that it is refused before.
    scene.physics.regression = Regression::fixed;
    scene.surface.burn_rate = 9e-3;
    scene.time.step = 2e-3;
    scene.time.end = 16e-3;
    scene.output = {};
    EXPECT_THROW(runs_.get(scene), NumericalFailure);
    EXPECT_FALSE(runs_.has(scene));
    int told = 0;
    EXPECT_THROW(runs_.get(scene, [&](double) { ++told; }), NumericalFailure);
}

TEST(RunIdentity, UnitesWhatIsAskedOfOneRun) {
    Scene other = small_scene(40e-6);
    other.bottom.temperature = 301.0;
    const auto runs = united(std::vector{small_scene(40e-6), other, small_scene(60e-6)});
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_DOUBLE_EQ(*runs[0].output.checkpoint_every, 20e-6);
    EXPECT_DOUBLE_EQ(*runs[1].output.checkpoint_every, 40e-6);
}

TEST(RunIdentity, NeverIsCoveredByAnything) {
    EXPECT_TRUE(covers({}, {}, 1e-6));
    EXPECT_TRUE(covers({.checkpoint_every = 4e-6}, {}, 1e-6));
    EXPECT_TRUE(covers({.checkpoint_every = 4e-6}, {.checkpoint_every = 8e-6}, 1e-6));
    EXPECT_FALSE(covers({.checkpoint_every = 4e-6}, {.checkpoint_every = 6e-6}, 1e-6));
    EXPECT_FALSE(covers({}, {.checkpoint_every = 6e-6}, 1e-6));
    EXPECT_FALSE(covers({.history_every = 2}, {.history_every = 1}, 1e-6));
}

TEST(RunIdentity, CountsAnIntervalBetweenStepsForItselfAlone) {
    EXPECT_TRUE(covers({.checkpoint_every = 50e-6}, {.checkpoint_every = 50e-6}, 20e-6));
    EXPECT_FALSE(covers({.checkpoint_every = 50e-6}, {.checkpoint_every = 60e-6}, 20e-6));
    EXPECT_FALSE(covers({.checkpoint_every = 50e-6}, {.checkpoint_every = 100e-6}, 20e-6));
    EXPECT_TRUE(covers({.checkpoint_every = 20e-6}, {.checkpoint_every = 50e-6}, 20e-6));
    const Output both = united({.checkpoint_every = 50e-6}, {.checkpoint_every = 60e-6}, 20e-6);
    EXPECT_EQ(both.checkpoint_every, 20e-6);
}

}  // namespace
}  // namespace crawford
