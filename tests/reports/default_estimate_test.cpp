/// One default estimate of uncertainty, and all who need one take that.
#include "reports/default_estimate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <vector>

#include "base/source_tree.hpp"
#include "reports/estimate.hpp"
#include "reports/study.hpp"
#include "reports/value_order.hpp"

namespace crawford::reports {
namespace {

const std::vector<double> sizes{0.25, 0.125, 0.0625, 0.03125};

/// At the expected order, at another, at too high a one, swinging, diverging.
const std::vector<std::vector<double>> shapes{{1.16, 1.04, 1.01, 1.0025},
                                              {1.4, 1.2, 1.1, 1.05},
                                              {9.0, 2.0, 1.1, 1.0},
                                              {1.3, 0.8, 1.1, 1.0},
                                              {1.0, 1.1, 1.3, 1.9}};

double by_order(const std::vector<double>& values) {
    for (const Estimate& estimate : estimates({sizes, values}, 2.0))
        if (estimate.name == default_estimate) return estimate.uncertainty;
    return Estimate::none;
}

TEST(DefaultEstimate, IsTheOneThatOrderMarks) {
    for (const auto& values : shapes)
        EXPECT_EQ(by_order(values), default_limit(sizes, values, 2.0).uncertainty);
}

TEST(DefaultEstimate, IsTakenByGates) {
    for (const auto& values : shapes) {
        std::vector<ValueLevel> as_values;
        std::vector<Level> as_errors;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            as_values.push_back({int(1.0 / sizes[i]), sizes[i], values[i]});
            as_errors.push_back({int(1.0 / sizes[i]), sizes[i], values[i]});
        }
        const Gate gate{"u", Norm::magnitude, expect(2.0), "a test"};
        EXPECT_EQ(judge(gate, ValueConvergence(as_values)).limit.uncertainty, by_order(values));
        EXPECT_EQ(judge(gate, Convergence(as_errors), {4, 8, 16, 32}).limit.uncertainty,
                  by_order(values));
    }
}

TEST(DefaultEstimate, IsTakenByBoundsOfALimit) {
    for (const auto& values : shapes) {
        Study study("a study");
        study.refines("cells", {4, 8, 16, 32})
            .measure([&](int cells) {
                const auto k = std::ranges::find(sizes, 1.0 / cells) - sizes.begin();
                return Measurement(1.0 / cells).value("u", values[std::size_t(k)]);
            })
            .limit_bound("u", 2.0, between(-1e3, 1e3), "a test");
        EXPECT_EQ(run(study).front().limit.uncertainty, by_order(values));
    }
}

/// Sources that call `extrapolate`, but for those that make it.
std::vector<std::string> who_call_extrapolate() {
    const std::regex call(R"(\bextrapolate\()");
    std::vector<std::string> found;
    for (const char* room : {"reports", "cases", "program", "python"})
        for (const auto& file : std::filesystem::recursive_directory_iterator(source_path(room))) {
            if (file.path().extension() != ".cpp") continue;
            std::ifstream stream(file.path());
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            if (std::regex_search(text, call)) found.push_back(file.path().filename());
        }
    std::ranges::sort(found);
    return found;
}

/// So that the ledger, and whoever comes, takes the default where it stands.
TEST(DefaultEstimate, HasNoOtherWayIn) {
    EXPECT_THAT(who_call_extrapolate(),
                testing::ElementsAre("default_estimate.cpp", "estimate.cpp", "extrapolate.cpp"));
    std::ifstream ledger(source_path("cases/paper/ledger/refinements.cpp"));
    const std::string text{std::istreambuf_iterator<char>(ledger), {}};
    EXPECT_THAT(text, testing::HasSubstr("default_limit("));
}

}  // namespace
}  // namespace crawford::reports
