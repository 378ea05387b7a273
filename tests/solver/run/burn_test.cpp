// From a scene to files: an unbroken run, a restarted one, one that fails, one that may not begin.
#include "solver/run/burn.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

/// A coarse sandwich, a millisecond of it.
Scene sandwich() {
    Scene scene;
    scene.title = "small sandwich";
    scene.domain = {.width = 240e-6, .depth = 480e-6, .nx = 16, .ny = 12, .half = true};
    scene.morphology = {Sandwich{60e-6}, {ammonium_perchlorate(), htpb_binder()}};
    scene.surface.pressure = 2e6;
    scene.surface.heat_flux = {8.368e6, 6.6944e6};
    scene.time = {.step = 20e-6, .end = 1e-3, .until_steady = {}};
    scene.output = {.snapshots_every = 0.2e-3, .checkpoint_every = 0.4e-3, .history_every = 2};
    return scene;
}

class OutputBurn : public OutputTest {
protected:
    BurnOptions options(const std::string& name) const {
        BurnOptions options;
        options.name = "run";
        options.directory = directory / name;
        return options;
    }
    std::string manifest_outcome(const std::string& name) const {
        const auto text = content(directory / name / "manifest.json");
        return nlohmann::json::parse(text).at("outcome");
    }
    void expect_same_files(const std::filesystem::path& a, const std::filesystem::path& b) const {
        EXPECT_EQ(content(a / "run_history.csv"), content(b / "run_history.csv"));
        EXPECT_EQ(content(a / "run.hdf.series"), content(b / "run.hdf.series"));
        const auto last = Hdf5File::open(a / "run_checkpoint_000050.h5");
        const auto other = Hdf5File::open(b / "run_checkpoint_000050.h5");
        for (const char* field :
             {"time", "surface", "temperature", "velocity", "deviator_0", "deviator_3", "pressure",
              "temperature_rate", "reference_shift"}) {
            const std::string path = std::string("/state/") + field;
            const auto numbers = last.read<double>(path);
            const auto others = other.read<double>(path);
            ASSERT_EQ(numbers.size(), others.size()) << path;
            EXPECT_EQ(0,
                      std::memcmp(numbers.data(), others.data(), sizeof(double) * numbers.size()))
                << path;
        }
    }
};

TEST_F(OutputBurn, LeavesEveryFileWhole) {
    const BurnOutcome outcome = burn(sandwich(), options("out"));
    EXPECT_EQ(outcome.step, 50);
    EXPECT_FALSE(outcome.steady);
    EXPECT_GT(outcome.summary.largest_temperature, 300.0);
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory / "out"))
        names.push_back(entry.path().filename());
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{
                         "manifest.json", "run.hdf.series", "run_000000.hdf", "run_000010.hdf",
                         "run_000020.hdf", "run_000030.hdf", "run_000040.hdf", "run_000050.hdf",
                         "run_checkpoint_000020.h5", "run_checkpoint_000040.h5",
                         "run_checkpoint_000050.h5", "run_history.csv"}));
    EXPECT_EQ(manifest_outcome("out"), "done");
    const std::string history = content(directory / "out" / "run_history.csv");
    EXPECT_EQ(std::ranges::count(history, '\n'), 1 + 25) << "a header and every second step";
}

class OutputRestart : public OutputBurn, public ::testing::WithParamInterface<LinearSolver> {};

TEST_P(OutputRestart, InPlaceGoesOnBitForBit) {
    Scene scene = sandwich();
    scene.numerics.solver = GetParam();
    burn(scene, options("unbroken"));
    Scene shorter = scene;
    shorter.time.end = 0.7e-3;
    burn(shorter, options("broken"));
    BurnOptions again = options("broken");
    again.restart = directory / "broken" / "run_checkpoint_000020.h5";
    burn(scene, again);
    // Step 35, where the first part ended, has a snapshot that the unbroken run has not; it is not
    // in the series.
    expect_same_files(directory / "unbroken", directory / "broken");
}

INSTANTIATE_TEST_SUITE_P(Solvers, OutputRestart,
                         ::testing::Values(LinearSolver::cholmod, LinearSolver::pcg),
                         [](const auto& solver) {
                             return solver.param == LinearSolver::pcg ? "pcg" : "cholmod";
                         });

TEST_F(OutputBurn, ThatFailsKeepsTheLastGoodState) {
    Sources sources;
    sources.heat = [](double, double, double t) {
        return t > 0.29e-3 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    };
    const auto message =
        message_of<NumericalFailure>([&] { burn(sandwich(), options("out"), sources); });
    EXPECT_NE(message.find("step 1"), std::string::npos) << message;  // 14 or 15: where q is taken
    EXPECT_NE(message.find("the last good state is kept in"), std::string::npos) << message;
    const std::filesystem::path kept = message.substr(message.find(directory.string()));
    const auto temperature = Hdf5File::open(kept).read<double>("/state/temperature");
    for (const double t : temperature) EXPECT_TRUE(std::isfinite(t));
    const long step = Hdf5File::open(kept).read<std::int64_t>("/state/step").at(0);
    EXPECT_NEAR(double(step), 14.0, 1.0);
    EXPECT_TRUE(content(directory / "out" / "run.hdf.series")
                    .find("run_0000" + std::to_string(step) + ".hdf") != std::string::npos);
    EXPECT_TRUE(manifest_outcome("out").starts_with("failed: step"));
}

TEST_F(OutputBurn, ThatFailsBeyondALimitNamesItInsteadOfASmallerStep) {
    Scene runs_away = sandwich();
    runs_away.physics = {.mechanics = false, .reference_map = false};
    runs_away.morphology.materials[0].heat_of_reaction = 2e6;  // beyond its onset
    runs_away.time.end = 20e-3;
    const auto message = message_of<NumericalFailure>([&] { burn(runs_away, options("out")); });
    EXPECT_NE(message.find("likely because of onset = "), std::string::npos) << message;
    EXPECT_EQ(message.find("; reduce time.step"), std::string::npos) << message;
}

/// What the machine could not do says nothing of the numbers.
TEST_F(OutputBurn, WithoutRoomIsCutOffAndHasNotFailed) {
    BurnOptions short_of_memory = options("memory");
    short_of_memory.watch = [](const BurnProgress& progress) {
        if (progress.now.step == 30) throw std::bad_alloc();
    };
    EXPECT_THROW(burn(sandwich(), short_of_memory), std::bad_alloc);
    EXPECT_EQ(manifest_outcome("memory"), "cut off: out of memory");

    short_of_memory.watch = [](const BurnProgress&) {
        throw std::filesystem::filesystem_error("",
                                                std::make_error_code(std::errc::not_enough_memory));
    };
    EXPECT_THROW(burn(sandwich(), short_of_memory), std::filesystem::filesystem_error);
    EXPECT_EQ(manifest_outcome("memory"), "cut off: out of memory");

    BurnOptions disk_full = options("disk");
    disk_full.watch = [](const BurnProgress&) { throw InputError("no space left"); };
    EXPECT_THROW(burn(sandwich(), disk_full), InputError);
    EXPECT_EQ(manifest_outcome("disk"), "cut off: no space left");
}

TEST_F(OutputBurn, IntoAnUnwritableDirectoryDoesNotBegin) {
    put(directory / "file", "");
    Sources sources;
    sources.heat = [](double, double, double) -> double {
        ADD_FAILURE() << "something was computed";
        return 0.0;
    };
    EXPECT_THROW(burn(sandwich(), options("file/out"), sources), InputError);
}

TEST_F(OutputBurn, FromACheckpointOfAnotherSceneWritesNothing) {
    const auto checkpoint = burn(sandwich(), options("first")).checkpoint;
    Scene other = sandwich();
    other.surface.pressure = 3e6;
    BurnOptions second = options("second");
    second.restart = checkpoint;
    const auto message = message_of<InputError>([&] { burn(other, second); });
    EXPECT_NE(message.find("surface.pressure"), std::string::npos) << message;
    const auto over = message_of<InputError>([&] { burn(sandwich(), second); });
    EXPECT_NE(over.find("not before time.end"), std::string::npos) << over;
    EXPECT_FALSE(std::filesystem::exists(directory / "second"));
}

TEST_F(OutputBurn, EndsEarlyWhenSteady) {
    Scene scene = sandwich();
    scene.physics = {.mechanics = false, .reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {0.0,
                               0.0};  // nothing happens: steady as soon as a millisecond is over
    scene.time = {.step = 20e-6, .end = 1.0, .until_steady = 1e-6};
    const BurnOutcome outcome = burn(scene, options("out"));
    EXPECT_TRUE(outcome.steady);
    EXPECT_EQ(outcome.step, 51) << "the first step and a millisecond";

    BurnOptions again = options("again");
    again.restart = directory / "out" / "run_checkpoint_000020.h5";
    EXPECT_EQ(burn(scene, again).step, outcome.step) << "the window is kept with the checkpoint";
}

TEST_F(OutputBurn, BooksTheTimeOfItsModulesAndTellsWhoWatches) {
    BurnOptions watched = options("out");
    std::vector<long> steps;
    watched.watch = [&](const BurnProgress& at) {
        EXPECT_EQ(at.first_step, 0);
        EXPECT_EQ(at.last_step, 50);
        steps.push_back(at.now.step);
    };
    const BurnOutcome outcome = burn(sandwich(), watched);
    EXPECT_EQ(steps.size(), 50U);
    EXPECT_EQ(steps.back(), 50);
    EXPECT_EQ(outcome.steps, 50);
    for (const char* module : {"projection", "heat"})
        EXPECT_NE(std::ranges::find(outcome.timing, module, &ModuleTime::module),
                  outcome.timing.end())
            << module;
}

}  // namespace

}  // namespace crawford
