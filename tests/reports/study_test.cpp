#include "reports/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/scratch.hpp"
#include "reports/judgement.hpp"

namespace crawford::reports {
namespace {

/// A "solver" of order two: every nodal value of sin is off by h^2, the surface value by 3 h^2.
Measurement second_order(int n) {
    const double h = 1.0 / n;
    std::vector<double> values, truth, common;
    for (int i = 0; i <= n; ++i) {
        truth.push_back(std::sin(i * h));
        values.push_back(truth.back() + h * h);
        if (i % (n / 32) == 0) common.push_back(values.back());
    }
    return Measurement(h)
        .field("temperature", values, truth)
        .sample("temperature", {common, {}})
        .value("T_s", 900.0 + 3.0 * h * h, 900.0);
}

Study study() {
    return Study("synthetic").refines("cells", {32, 64, 128, 256}).measure(second_order);
}

TEST(StudyRun, JudgesEveryRowInOrder) {
    auto s = study();
    s.gate("temperature", Norm::L2, expect(2.0).within(0.01), "h^2 added")
        .gate("temperature", Norm::Linf, expect(2.0).within(0.01).from(64).to(256), "h^2 added")
        .gate("T_s", Norm::magnitude, expect(2.0).within(0.01), "3 h^2 added")
        .difference_gate("temperature", Norm::L1, expect(2.0).within(0.01).to(256), "h^2 added")
        .difference_gate("T_s", Norm::magnitude, expect(2.0).within(0.01), "3 h^2 added")
        .bound("T_s", 128, between(900.0, 900.0002), "3/128^2 = 1.83e-4")
        // Round-off of 900, 1e-13, through three differences.
        .limit_bound("T_s", 2.0, between(900.0 - 1e-11, 900.0 + 1e-11),
                     "a pure power extrapolates exactly");
    const auto results = run(s);
    ASSERT_EQ(results.size(), 7U);
    EXPECT_TRUE(all_passed(results)) << table(results);
    EXPECT_EQ(results[0].study, "synthetic");
    EXPECT_EQ(results[3].finest, 128) << "a difference stands for its coarser grid";
    EXPECT_NEAR(results[6].limit.observed, 2.0, 1e-6);
    EXPECT_NEAR(results[0].scale, std::sqrt(0.5 - std::sin(2.0) / 4.0), 1e-2)
        << "L2 of sin on [0,1]";
}

TEST(StudyRun, GatesOnTheCallersGridsWhatTheySufficeFor) {
    auto s = study();
    s.gate("temperature", Norm::L2, expect(2.0).within(0.01).to(128), "h^2 added")
        .difference_gate("T_s", Norm::magnitude, expect(2.0).within(0.01).to(128), "3 h^2 added")
        .bound("T_s", 64, between(0, 1e3), "any");
    const auto results = run(s, {128, 32, 64, 64});
    EXPECT_EQ(results[0].grids, (std::vector{32, 64, 128}));
    EXPECT_TRUE(all_passed(results)) << table(results);
}

TEST(StudyRun, TotalsTheSettingsOfAList) {
    Study s("list");
    s.lists("setting", 3)
        .run([](Record& record) {
            const int setting = record.setting.count("setting");
            record.said = "heard";
            record.found =
                Measurement().value("odd", setting % 2).value("three", setting == 3 ? 1.0 : 0.0);
        })
        .total("odd", between(2, 2), "1 and 3")
        .total("three", at_most(0), "3 is over");
    const auto results = run(s);
    EXPECT_EQ(results[0].quantity, "odd, all runs");
    EXPECT_EQ(results[0].value, 2.0);
    EXPECT_TRUE(results[0].passed) << results[0].failure;
    EXPECT_FALSE(results[1].passed);
    EXPECT_TRUE(results[1].fell_short());
}

TEST(StudyRun, ThatFindsMemoryShortJudgesNothing) {
    Study s("short");
    s.lists("setting", 4)
        .measure([](int setting) -> Measurement {
            if (setting == 2) throw std::bad_alloc();
            return Measurement().value("wrong", 0.0);
        })
        .total("wrong", at_most(0), "none");
    int told = 0;
    EXPECT_THROW(run(s, {}, [&](const Progress&) { ++told; }), std::bad_alloc);
    EXPECT_EQ(told, 3) << "what was not run is not told of";

    s.measure([](int) -> Measurement {
        throw std::system_error(std::make_error_code(std::errc::not_enough_memory));
    });
    EXPECT_THROW(run(s), std::system_error) << "a call of the system that did not get it";
}

TEST(StudyRun, HasNoTotalWhereOneRunFailed) {
    Study s("list");
    s.lists("setting", 3)
        .measure([](int setting) {
            if (setting == 2) throw std::runtime_error("no convergence");
            return Measurement().value("wrong", 0.0);
        })
        .total("wrong", at_most(0), "none");
    const auto result = run(s).front();
    EXPECT_TRUE(result.fell_short());
    EXPECT_NE(result.failure.find("no value from run 2"), std::string::npos) << result.failure;
    EXPECT_NE(result.failure.find("no convergence"), std::string::npos) << result.failure;
}

/// Every kind of row, each in need of grid 256.
Study all_rows() {
    auto s = study();
    s.gate("temperature", Norm::L2, expect(2.0).within(0.01), "h^2 added")
        .difference_gate("temperature", Norm::L2, expect(2.0).within(0.01), "h^2 added")
        .bound("T_s", 256, between(0, 1e3), "any")
        .limit_bound("T_s", 2.0, between(0, 1e3), "any")
        .total("T_s", between(0, 1e4), "any");
    return s;
}

TEST(StudyRun, LeavesUngatedWhatTheCallersGridsDoNotSufficeFor) {
    for (const auto& grids : {std::vector{32, 64}, std::vector{32}, std::vector{32, 64, 128}})
        for (const auto& result : run(all_rows(), grids)) {
            EXPECT_FALSE(result.gated) << result.quantity;
            EXPECT_FALSE(result.passed) << result.quantity;
            EXPECT_FALSE(result.fell_short()) << result.quantity;
            EXPECT_EQ(result.verdict, "too few grids to gate");
            EXPECT_NE(result.failure.find("256 not run"), std::string::npos) << result.failure;
        }
}

TEST(StudyRun, LeavesEverythingUngatedOnNoGridAtAll) {
    const auto results = run({Task{.study = all_rows(), .grids = std::vector<int>{}}});
    ASSERT_EQ(results.at(0).gates.size(), 5U);
    EXPECT_EQ(count(results[0].gates).not_gated, 5U);
    EXPECT_EQ(results[0].gates[0].quantity, "temperature");
}

TEST(StudyRun, FailsWhatIsBrokenOnTheCallersGridsEvenIfTheyAreTooFew) {
    const auto measured = [](double value) {
        Study s("broken");
        s.refines("cells", {32, 64, 128}).measure([value](int n) {
            return Measurement(1.0 / n).error("T", Norm::L2, value / n).value("T_s", value);
        });
        s.gate("T", Norm::L2, expect(1.0).within(0.1), "h")
            .bound("T_s", 128, between(0, 1), "any")
            .limit_bound("T_s", 1.0, between(0, 1), "any");
        return run(s, {32, 64});
    };
    for (const auto& result : measured(1.0)) EXPECT_FALSE(result.gated);
    for (const auto& result : measured(std::nan(""))) EXPECT_TRUE(result.fell_short());

    auto s = all_rows();
    s.measure([](int n) {
        if (n == 32) throw std::runtime_error("no convergence");
        return second_order(n);
    });
    for (const auto& result : run(s, {32, 64})) {
        EXPECT_TRUE(result.fell_short()) << result.quantity;
        EXPECT_NE(result.failure.find("grid 32: no convergence"), std::string::npos);
    }
}

TEST(StudyRun, FailsGatesOnGridsThatTheStudyDoesNotHave) {
    auto s = study();
    s.bound("T_s", 512, between(0, 1e3), "any")
        .gate("temperature", Norm::L2, expect(2.0).within(0.01).to(512), "h^2 added");
    for (const auto& result : run(s)) EXPECT_TRUE(result.fell_short());
}

TEST(StudyRun, FeedsAllStudiesOutOfOneQueueDearestFirst) {
    std::vector<std::string> begun;
    std::mutex mutex;
    const auto noting = [&](const std::string& name) {
        Study s(name);
        s.refines("cells", {10, 20}).measure([&, name](int n) {
            const std::scoped_lock lock(mutex);
            begun.push_back(name + std::to_string(n));
            return Measurement(1.0 / n).value("x", n);
        });
        s.bound("x", 10, between(10, 10), "itself");
        return s;
    };
    std::vector<double> to_go;
    const auto results = run(
        {{.study = noting("cheap"), .seconds = 1.0}, {.study = noting("dear"), .seconds = 100.0}},
        nullptr, [&](const Progress& p) { to_go.push_back(p.to_go); });
    // Costs are 80, 20, 0.8 and 0.2: with several threads only the first and the last are certain.
    EXPECT_THAT(begun, testing::UnorderedElementsAre("cheap10", "cheap20", "dear10", "dear20"));
    EXPECT_NE(begun.back().find("cheap"), std::string::npos);
    ASSERT_EQ(results.size(), 2U);
    EXPECT_EQ(results[0].gates.at(0).study, "cheap");
    EXPECT_EQ(results[1].grids, (std::vector{10, 20}));
    EXPECT_TRUE(results[1].gates.at(0).passed);
    EXPECT_EQ(to_go.size(), 4U);
    EXPECT_NEAR(to_go.back(), 0.0, 1e-12);
}

TEST(StudyRun, RunsOnlyWhatIsNotThereAndFindsTheSame) {
    const Scratch scratch;
    const auto& directory = scratch.path();
    std::atomic<int> runs = 0;
    Study s("counted");
    s.at("element", "bbar").refines("cells", {32, 64, 128}).measure([&](const Setting& at) {
        ++runs;
        return second_order(at.count("cells"));
    });
    s.gate("temperature", Norm::L2, expect(2.0).within(0.01), "h^2 added")
        .difference_gate("T_s", Norm::magnitude, expect(2.0).within(0.01), "3 h^2 added");
    RecordStore first(directory, "a"), second(directory, "a"), other(directory, "b");
    const auto made = run({Task{s, std::vector{32, 64}}}, &first).at(0);
    EXPECT_EQ(runs, 2);
    const auto whole = run({Task{s}}, &second).at(0);
    EXPECT_EQ(runs, 3) << "two were there";
    EXPECT_EQ(whole.kept, 2U);
    EXPECT_EQ(whole.gates.at(0).errors.front(), made.gates.at(0).errors.front());
    EXPECT_TRUE(all_passed(whole.gates)) << table(whole.gates);
    const auto judged = judge_kept({Task{s}}, other).at(0);
    EXPECT_EQ(runs, 3) << "judging runs nothing";
    EXPECT_TRUE(judged.is_foreign);
    EXPECT_TRUE(all_passed(judged.gates)) << table(judged.gates);
    run({Task{s}}, &other);
    EXPECT_EQ(runs, 6) << "another program trusts none of them";
}

TEST(StudyRun, CarriesTheReasonOfARunThatThrew) {
    Study s("broken");
    s.refines("cells", {32, 64, 128, 256}).measure([](int n) {
        if (n == 64) throw std::runtime_error("no convergence in column 3");
        return second_order(n);
    });
    s.gate("temperature", Norm::L2, expect(2.0).within(0.1), "h^2")
        .difference_gate("temperature", Norm::L2, expect(2.0).within(0.1), "h^2")
        .limit_bound("T_s", 2.0, between(0, 1e3), "any")
        .bound("T_s", 64, between(0, 1e3), "any");
    for (const auto& result : run(s)) {
        EXPECT_FALSE(result.passed);
        EXPECT_NE(result.failure.find("grid 64: no convergence in column 3"), std::string::npos)
            << result.failure;
    }
}

TEST(StudyRun, FailsAQuantityThatNobodyMeasured) {
    auto s = study();
    s.gate("temprature", Norm::L2, expect(2.0).within(0.1), "a misspelling")
        .bound("T", 32, at_least(0.0), "another");
    for (const auto& result : run(s)) {
        EXPECT_FALSE(result.passed);
        EXPECT_NE(result.failure.find("from grid 32"), std::string::npos) << result.failure;
    }
}

TEST(StudyRun, FailsSamplesOfDifferentPoints) {
    Study s("uneven");
    s.refines("cells", {32, 64, 128}).measure([](int n) {
        return Measurement(1.0 / n).sample(
            "T", {std::vector<double>(static_cast<std::size_t>(n), 1.0), {}});
    });
    s.difference_gate("T", Norm::L2, expect(2.0).within(0.1), "h^2");
    EXPECT_NE(run(s)[0].failure.find("differ in number"), std::string::npos);
}

TEST(StudyRun, FailsAStudyOfTwoGrids) {
    auto s = study();
    s.refines("cells", {32, 64})
        .gate("temperature", Norm::L2, expect(2.0).within(0.1), "h^2")
        .difference_gate("temperature", Norm::L2, expect(2.0).within(0.1), "h^2")
        .limit_bound("T_s", 2.0, between(0, 1e3), "any");
    for (const auto& result : run(s)) EXPECT_TRUE(result.fell_short()) << result.quantity;
}

TEST(StudyRun, RefusesAStudyOfNothing) {
    EXPECT_THROW(run(Study("nothing")), std::invalid_argument);
    EXPECT_THROW(run(study()), std::invalid_argument) << "no gate";
    EXPECT_THROW(run(Study("x").measure(second_order).bound("T_s", 32, at_least(0), "r")),
                 std::invalid_argument);
}

TEST(StudyRun, ReportsEveryGridAndUsesNoMoreThreadsThanThereAre) {
    std::atomic<int> now = 0, most = 0;
    Study s("counted");
    s.refines("cells", {1, 2, 3, 4, 5, 6, 7, 8}).measure([&](int n) {
        const int running = ++now;
        int seen = most;
        while (running > seen && !most.compare_exchange_weak(seen, running)) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        --now;
        return Measurement(1.0 / n).value("x", 1.0);
    });
    s.bound("x", 1, at_least(0.0), "any");
    std::set<int> reported;
    std::size_t last = 0;
    run(s, {}, [&](const Progress& p) {
        reported.insert(p.setting.count("cells"));
        EXPECT_EQ(p.done, ++last);
        EXPECT_EQ(p.total, 8U);
    });
    const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    EXPECT_EQ(reported.size(), 8U);
    EXPECT_LE(most, threads);
    if (threads > 1) {
        EXPECT_GT(most, 1) << "grids were run one after the other";
    }
}

}  // namespace
}  // namespace crawford::reports
