#include "reports/against.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/scratch.hpp"
#include "reports/verification.hpp"

namespace crawford::reports {
namespace {

using testing::HasSubstr;

GateResult of_order(const std::string& study, double factor = 1.0) {
    std::vector<Level> levels;
    for (const int n : {32, 64, 128}) levels.push_back({n, 1.0 / n, factor / (n * n)});
    auto result = judge(Gate{"T", Norm::L2, expect(2.0).within(0.1), "central differences"},
                        Convergence(levels), {32, 64, 128});
    result.study = study;
    return result;
}

GateResult of_bound(double value) {
    auto result = judge(Bound{"T_s [K]", between(0.0, 1.0), "the model"}, value);
    result.study = "heat";
    return result;
}

std::vector<Change> changes(const Comparison& comparison) {
    std::vector<Change> all;
    for (const auto& one : comparison.changed) all.push_back(one.change);
    return all;
}

Comparison held(const std::vector<GateResult>& before, const std::vector<GateResult>& now,
                const Yardstick& yardstick = {}) {
    return compare(before, now, {}, yardstick);
}

constexpr Yardstick exact{.grown = 1.05, .exact = true};

TEST(Against, ItselfNothingIsListed) {
    const std::vector<GateResult> gates{of_order("heat"), of_order("slab"), of_bound(0.5)};
    for (const Yardstick& yardstick : {Yardstick{}, exact}) {
        const auto found = held(gates, gates, yardstick);
        EXPECT_TRUE(found.changed.empty()) << text(found);
        EXPECT_EQ(found.compared, 3U);
        EXPECT_FALSE(found.fell_short());
    }
}

TEST(Against, AnErrorThatTriplesAtTheSameOrderHasGrown) {
    const auto worse = of_order("heat", 3.0);
    ASSERT_TRUE(worse.passed) << "no gate of order sees it";
    const auto found = held({of_order("heat")}, {worse});
    EXPECT_EQ(changes(found), std::vector{Change::grown});
    EXPECT_TRUE(found.fell_short());
    EXPECT_NEAR(found.largest_growth, 3.0, 1e-12);
    EXPECT_THAT(text(found), HasSubstr("grown: heat/T, L2"));
}

TEST(Against, AnErrorThatIsNoNumberAnyMoreHasGrown) {
    for (const double before : {1.0, 0.0}) {
        auto sound = of_order("heat"), broken = sound;
        sound.errors.back() *= before;  // 0: no yardstick for growth, but a number
        broken.errors.back() = std::numeric_limits<double>::quiet_NaN();
        const auto found = held({sound}, {broken});
        EXPECT_EQ(changes(found), std::vector{Change::grown});
        EXPECT_TRUE(found.fell_short());
    }
}

TEST(Against, TheFactorSaysHowMuchIsGrown) {
    const std::vector before{of_order("heat")};
    EXPECT_FALSE(held(before, {of_order("heat", 1.04)}).fell_short());
    EXPECT_TRUE(held(before, {of_order("heat", 1.06)}).fell_short());
    EXPECT_FALSE(
        held(before, {of_order("heat", 1.06)}, {.grown = 1.1, .exact = false}).fell_short());
    EXPECT_TRUE(
        held(before, {of_order("heat", 1.0001)}, {.grown = 1.0, .exact = false}).fell_short());
}

TEST(Against, AnErrorThatShrankIsListedAndNoFault) {
    const auto found = held({of_order("heat")}, {of_order("heat", 0.5)});
    EXPECT_EQ(changes(found), std::vector{Change::shrunk});
    EXPECT_FALSE(found.fell_short());
    EXPECT_TRUE(held({of_order("heat")}, {of_order("heat", 0.5)}, exact).fell_short());
}

TEST(Against, ListsWhatIsGoneAndNew) {
    const auto found =
        held({of_order("heat"), of_order("slab")}, {of_order("heat"), of_bound(0.5)});
    EXPECT_EQ(changes(found), (std::vector{Change::gone, Change::added}));
    EXPECT_EQ(found.compared, 1U);
    EXPECT_FALSE(found.fell_short());
    EXPECT_THAT(text(found), HasSubstr("gone: slab/T, L2\nnew: heat/T_s [K]\n"));
    EXPECT_TRUE(held({of_order("heat"), of_order("slab")}, {of_order("heat")}, exact).fell_short());
}

TEST(Against, WhatWasNotAskedForIsNotGone) {
    const std::vector before{of_order("heat"), of_order("slab"), of_bound(0.5)};
    const Scope heat{.every_study = false, .studies = {"heat"}, .own_grids = true};
    const auto found = compare(before, {of_order("heat")}, heat, exact);
    EXPECT_EQ(changes(found), std::vector{Change::gone}) << "the bound of heat";
    EXPECT_EQ(found.left_out, 1U);
    const Scope few{.every_study = false, .studies = {"heat"}, .own_grids = false};
    EXPECT_TRUE(compare(before, {of_order("heat")}, few, exact).changed.empty());
}

TEST(Against, AQuickLookIsNotCompared) {
    auto quick = of_order("heat", 3.0);
    leave_ungated(quick, {128});
    Scope few;
    few.own_grids = false;
    const auto found = compare({of_order("heat")}, {quick}, few, {});
    EXPECT_TRUE(found.changed.empty()) << text(found);
    EXPECT_EQ(found.left_out, 1U);
    EXPECT_EQ(changes(held({of_order("heat")}, {quick})).front(), Change::lost)
        << "all grids were to be there";
}

TEST(Against, AGateThatPassedAndDoesNotIsLost) {
    auto failing = of_order("heat");
    failing.passed = false;
    failing.failure = "errors are oscillating";
    const auto found = held({of_order("heat")}, {failing});
    EXPECT_EQ(changes(found), std::vector{Change::lost});
    EXPECT_THAT(text(found), HasSubstr("lost: heat/T, L2\n    errors are oscillating"));
    EXPECT_EQ(changes(held({failing}, {of_order("heat")})), std::vector{Change::other});
}

TEST(Against, RoundOffIsSaidAndNeverGrown) {
    const auto found = held({of_order("heat", 1e-13)}, {of_order("heat", 1e-12)});
    ASSERT_FALSE(found.changed.empty());
    EXPECT_EQ(changes(found), std::vector{Change::from_roundoff});
    EXPECT_FALSE(found.fell_short());
    auto none = of_order("heat");
    none.errors.assign(3, 0.0);
    none.scale = 0.0;
    EXPECT_TRUE(held({none}, {none}).changed.empty()) << "0 against 0";
}

TEST(Against, ExactSeesOneBitOfEachNumber) {
    const auto before = of_order("heat");
    const auto moved = [&](auto change) {
        auto now = before;
        change(now);
        const auto found = held({before}, {now}, exact);
        EXPECT_TRUE(held({before}, {now}).changed.empty());
        return found.count(Change::other) == 1 ? found.changed.front().detail : text(found);
    };
    const auto up = [](double& x) { x = std::nextafter(x, 1e9); };
    EXPECT_EQ(moved([&](GateResult& g) { up(g.errors[0]); }), "errors");
    EXPECT_EQ(moved([&](GateResult& g) { up(g.errors[2]); }), "errors");
    EXPECT_EQ(moved([&](GateResult& g) { up(g.h[1]); }), "h");
    EXPECT_EQ(moved([&](GateResult& g) { up(g.fit); }), "fit");
    EXPECT_EQ(moved([&](GateResult& g) { up(g.scale); }), "scale");
    EXPECT_EQ(moved([&](GateResult& g) { up(g.pairwise[1]); }), "pairwise_orders");
    EXPECT_EQ(moved([&](GateResult& g) { g.values = {1.0}; }), "values");
    EXPECT_TRUE(moved([](GateResult& g) { g.seconds = 99.0; }).starts_with("1 gates compared"));
}

TEST(Against, AChangedValueOfABoundIsOtherWhereExact) {
    EXPECT_TRUE(held({of_bound(0.1)}, {of_bound(0.9)}).changed.empty());
    const auto found = held({of_bound(0.1)}, {of_bound(0.9)}, exact);
    EXPECT_EQ(changes(found), std::vector{Change::other});
    EXPECT_EQ(found.changed[0].detail, "value");
    EXPECT_EQ(changes(held({of_bound(0.1)}, {of_bound(1.5)})), std::vector{Change::lost});
}

TEST(Against, GatesOfOneNameAreMatchedInTheirOrder) {
    const std::vector twins{of_order("heat"), of_order("heat", 5.0)};
    EXPECT_TRUE(held(twins, twins, exact).changed.empty());
    EXPECT_EQ(changes(held(twins, {twins[0]})), std::vector{Change::gone});
}

TEST(Against, OtherGridsAreComparedOnTheFinestThatBothHave) {
    auto coarse = of_order("heat");
    coarse.grids.pop_back();
    coarse.errors.pop_back();
    EXPECT_TRUE(held({coarse}, {of_order("heat")}).changed.empty());
    EXPECT_EQ(changes(held({coarse}, {of_order("heat")}, exact)), std::vector{Change::other});
}

TEST(Against, StaysWithinEightyColumns) {
    auto far = of_order("a study " + std::string(200, 'x') + " of a name", 7.0);
    std::istringstream lines(text(held({of_order("heat")}, {far, of_bound(0.5)})));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Against, NullIsNullInAFile) {
    const Scratch scratch;
    const auto file = scratch.path() / "verify.json";
    Verification v;
    v.gates = {of_order("heat"), of_bound(0.5)};
    v.gates[0].errors[0] = v.gates[0].fit = std::nan("");
    write(file, v);
    EXPECT_TRUE(held(read_gates(file), v.gates, exact).changed.empty());
    std::ofstream(file) << R"({"gates": [{"study": "heat"}]})";
    EXPECT_THROW(read_gates(file), InputError);
}

TEST(Against, SaysInPlainWordsWhatIsNoReport) {
    const Scratch scratch;
    const auto file = scratch.path() / "verify.json";
    std::ofstream(file) << R"({"a": 1})";
    try {
        read_gates(file);
        FAIL() << "taken";
    } catch (const InputError& problem) {
        const std::string what = problem.what();
        EXPECT_NE(what.find("is no verify.json of crawford: key 'gates' not found"),
                  std::string::npos)
            << what;
    }
}

}  // namespace
}  // namespace crawford::reports
