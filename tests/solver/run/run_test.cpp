// What a run tells on its way: progress, timing, manifest, when it is due, when it is steady.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "base/terminal.hpp"
#include "solver/files/manifest.hpp"
#include "solver/run/progress.hpp"
#include "solver/run/recorder.hpp"
#include "solver/run/steadiness.hpp"
#include "solver/run/timing_table.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

class OutputRun : public OutputTest {};

TEST_F(OutputRun, ProgressFitsATerminal) {
    EXPECT_EQ(progress_line({2100, 0.042, 0.004531}, 5000, 3723.0),
              " 42.0 %  step 2100 of 5000  t = 42.00 ms  r_b = 0.4531 cm/s  ETA 1:02:03");
    EXPECT_LE(progress_line({1'000'000'000, 1e6, 1e3}, 2'000'000'000, 1e9).size(), 79u);
}

TEST_F(OutputRun, ClockTimeIsReadAtAGlance) {
    EXPECT_EQ(clock_time(0.4), "0:00");
    EXPECT_EQ(clock_time(59.6), "1:00");
    EXPECT_EQ(clock_time(3599.0), "59:59");
    EXPECT_EQ(clock_time(36'000.0), "10:00:00");
}

TEST_F(OutputRun, ProgressRewritesOneLineAndEndsIt) {
    std::ostringstream terminal;
    {
        Progress progress(terminal, true, 0);
        for (long step = 1; step <= 1000; ++step)
            progress.show({step, 1e-5 * double(step), 0.0}, 1000);
    }
    const std::string text = terminal.str();
    EXPECT_EQ(std::ranges::count(text, '\n'), 1);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_NE(text.find("100.0 %  step 1000 of 1000"), std::string::npos) << "the last step";
    // A loop of a thousand empty steps takes milliseconds: the first, the last, perhaps one
    // between.
    EXPECT_LE(std::ranges::count(text, '\r'), 20);
}

TEST_F(OutputRun, ProgressIsSilentWhenNotShown) {
    std::ostringstream terminal;
    { Progress(terminal, false, 0).show({2, 1.0, 1.0}, 2); }
    EXPECT_EQ(terminal.str(), "");
}

TEST_F(OutputRun, TimingSharesOutTheWhole) {
    const std::string table = timing_table({{"heat", 1.0}, {"projection", 6.0}}, 8.0, 100);
    EXPECT_NE(table.find("projection                6.000   75.0 %     60.000"), std::string::npos)
        << table;
    EXPECT_NE(table.find("set-up and output         1.000   12.5 %     10.000"), std::string::npos)
        << table;
    EXPECT_NE(table.find("all 100 steps             8.000  100.0 %     80.000"), std::string::npos)
        << table;
}

TEST_F(OutputRun, OutputIsDueOncePerInterval) {
    // 5 ms in steps of 20 us, of 30 us (no divisor) and of 7 ms (longer than the interval).
    for (const double step : {20e-6, 30e-6, 7e-3}) {
        int due = 0;
        const auto steps = std::lround(0.1 / step);
        for (long n = 1; n <= steps; ++n)
            due += is_due(step * double(n - 1), step * double(n), 5e-3) ? 1 : 0;
        const int expected = step > 5e-3 ? int(steps) : int(double(steps) * step / 5e-3 + 1e-6);
        EXPECT_EQ(due, expected) << step;
    }
    // "20 us" is read as 1.9999999999999998e-05 s: step 500 ends at 0.009999999999999998 s.
    const double step = 1.9999999999999998e-05;
    EXPECT_TRUE(is_due(step * 499, step * 500, 5e-3)) << "on the very time, not a step later";
    EXPECT_FALSE(is_due(step * 500, step * 501, 5e-3));
}

TEST_F(OutputRun, ManifestSaysWhatItTakesToRepeatIt) {
    Manifest manifest;
    manifest.outcome = {ManifestOutcome::Kind::done};
    manifest.command = {"crawford", "burn", "a b.toml"};
    manifest.scene = "title = \"\xc3\xa4\"\n";
    manifest.seeds = {7, std::numeric_limits<std::uint64_t>::max()};
    manifest.restarted_from = "c.h5";
    manifest.last_step = 5;
    manifest.time = 0.25;
    manifest.results = RunResults{.regression_rate = 0.005,
                                  .mean_burn_rate = 0.0045,
                                  .largest_temperature = 930.0,
                                  .strain_about_peak = 0.4,
                                  .steady = true};
    manifest.started = std::chrono::system_clock::from_time_t(1'000'000'000);
    manifest.ended = manifest.started + std::chrono::milliseconds(2500);
    manifest.wall_seconds = 2.5;
    write_manifest(directory / "manifest.json", manifest);
    const auto json = nlohmann::json::parse(content(directory / "manifest.json"));
    EXPECT_EQ(json.at("version"), version());
    EXPECT_EQ(json.at("revision"), revision());
    EXPECT_EQ(json.at("compiler"), compiler());
    EXPECT_EQ(json.at("flags"), flags());
    EXPECT_EQ(json.at("command"), manifest.command);
    EXPECT_EQ(json.at("scene"), manifest.scene);
    EXPECT_EQ(json.at("seeds"), manifest.seeds);
    EXPECT_EQ(json.at("restarted_from"), "c.h5");
    EXPECT_EQ(json.at("started"), "2001-09-09T01:46:40Z");
    EXPECT_EQ(json.at("wall_seconds"), 2.5);
    EXPECT_GT(json.at("peak_memory_bytes"), 1'000'000);
    EXPECT_EQ(json.at("libraries").at("Eigen"), "3.4.0");
    for (const char* library : {"CHOLMOD", "BLAS", "HDF5", "Boost"})
        EXPECT_FALSE(json.at("libraries").at(library).get<std::string>().empty()) << library;
    EXPECT_GE(json.at("machine").at("cores"), 1);
    EXPECT_GT(json.at("machine").at("memory_bytes"), 1'000'000);
    EXPECT_NE(json.at("machine").at("system"), "unknown");
    const auto& results = json.at("results");
    EXPECT_EQ(results.at("regression_rate").at("value"), 0.005);
    EXPECT_EQ(results.at("regression_rate").at("unit"), "m/s");
    EXPECT_EQ(results.at("mean_burn_rate").at("value"), 0.0045);
    EXPECT_EQ(results.at("largest_temperature").at("unit"), "K");
    EXPECT_EQ(results.at("strain_within_5_um_of_max").at("value"), 0.4);
    EXPECT_EQ(results.at("steady"), true);
    EXPECT_EQ(results.at("steady_at").at("value"), 0.25);
}

Scene burning(double tolerance) {
    Scene scene;
    scene.time.step = 1e-4;
    scene.time.until_steady = tolerance;
    return scene;
}

/// First step at which a run with the mean burn rate r(t), all columns burning alike but for one
/// that is `delay` [s] late, counts as steady; 0 if none of 2000.
template <class Rate>
long steady_step(const Scene& scene, Rate rate, double delay = 0.0, long restart_at = -1) {
    auto steadiness = Steadiness(scene);
    State state;
    state.surface = {0.0, 0.0};
    for (state.step = 1; state.step <= 2000; ++state.step) {
        state.time = scene.time.step * double(state.step);
        Summary summary;
        summary.mean_burn_rate = rate(state.time);
        summary.largest_temperature = 900.0 - 100.0 * std::exp(-state.time / 5e-3);
        state.surface[0] -= scene.time.step * summary.mean_burn_rate;
        if (state.time > delay) state.surface[1] -= scene.time.step * summary.mean_burn_rate;
        steadiness.record(state, summary);
        if (steadiness.reached()) return state.step;
        if (state.step == restart_at) {
            Steadiness restarted(scene);
            restarted.resume(steadiness.window());
            steadiness = restarted;
        }
    }
    return 0;
}

constexpr double rate = 0.0045;

// AP: D/r_b^2 = 0.405/(1950 * 1255.2 * 0.0045^2) = 8.17 ms.
TEST_F(OutputRun, IsNotSteadyBeforeAThermalLayerHasBurnt) {
    const auto constant = [](double) { return rate; };
    EXPECT_EQ(steady_step(burning(1e-6), constant), 82);
    EXPECT_EQ(steady_step(burning(1e-6), constant, 5e-3), 132) << "the late column counts";
}

// At 0.03 cm/s the layer relaxes over 4 D/r_b^2 = 7.4 s: what does not move in a millisecond may in
// 74.
TEST_F(OutputRun, ASlowBurnIsSteadyByItsOwnRelaxationTime) {
    Scene scene = burning(1e-3);
    scene.time.step = 5e-3;
    const auto settling = [](double t) { return 0.0003 * (1.0 - std::exp(-t / 1.8)); };
    const long step = steady_step(scene, settling);
    ASSERT_GT(step, 0);
    EXPECT_LT(std::exp(-5e-3 * double(step) / 1.8), 0.03) << "what is left to go";
}

// r = r0 (1 - exp(-t/tau)), tau = 10 ms: the change over the last ms is (e^0.1 - 1) exp(-t/tau) =
// 1e-4 at 69.6 ms.
TEST_F(OutputRun, IsSteadyWhenTheRateChangesLessThanAskedPerMillisecond) {
    const auto settling = [](double t) { return rate * (1.0 - std::exp(-t / 10e-3)); };
    EXPECT_NEAR(double(steady_step(burning(1e-4), settling)), 696.0, 1.0);
}

TEST_F(OutputRun, IsNotSteadyWhileItOscillates) {
    // Over a whole period of 1 ms the ends of the window always agree.
    const auto oscillating = [](double t) {
        return rate * (1.0 + 1e-3 * std::sin(2.0 * 3.14159265358979 * t / 1e-3));
    };
    EXPECT_EQ(steady_step(burning(1e-4), oscillating), 0);
    EXPECT_NE(steady_step(burning(1e-2), oscillating), 0);
}

TEST_F(OutputRun, IsSteadyAtTheSameStepAfterARestart) {
    const auto settling = [](double t) { return rate * (1.0 - std::exp(-t / 10e-3)); };
    const long unbroken = steady_step(burning(1e-4), settling);
    for (const long before : {1, 5, 9})
        EXPECT_EQ(steady_step(burning(1e-4), settling, 0.0, unbroken - before), unbroken) << before;
}

// The temperature of steady_step reaches 900 K with tau = 5 ms: 1e-6 per ms at t = 5 ms ln(100
// (e^0.2 - 1)/(900e-6)) = 50.6 ms.
TEST_F(OutputRun, WatchesTheTemperatureWhereTheRateIsPrescribed) {
    Scene scene = burning(1e-6);
    scene.physics.regression = Regression::fixed;
    EXPECT_NEAR(double(steady_step(scene, [](double) { return rate; })), 506.0, 1.0);
}

// The steps that a run chooses are no multiples of the first, nor of a millisecond.
TEST_F(OutputRun, StepsOfAnyLengthLookBackAsFar) {
    Scene scene = burning(1e-4);
    scene.time.step = 1e-6;
    Steadiness steadiness(scene);
    State state;
    state.surface = {0.0};
    while (!steadiness.reached() && state.time < 0.2) {
        const double length = state.time == 0.0 ? 1e-6 : 2.3e-4;
        Summary summary;
        summary.mean_burn_rate = rate * (1.0 - std::exp(-state.time / 10e-3));
        state.time += length;
        state.surface[0] -= length * summary.mean_burn_rate;
        steadiness.record(state, summary);
    }
    EXPECT_NEAR(state.time, 69.6e-3, 2.0e-3) << "looks back up to a step further than 1 ms";
}

TEST_F(OutputRun, IsNeverSteadyWhereNobodyAsks) {
    Scene scene = burning(1e-6);
    scene.time.until_steady.reset();
    EXPECT_EQ(steady_step(scene, [](double) { return rate; }), 0);
}

}  // namespace

}  // namespace crawford
