#include "reports/verification.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/errors.hpp"
#include "base/scratch.hpp"
#include "reports/coverage.hpp"
#include "reports/study.hpp"

namespace crawford::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double infinity = std::numeric_limits<double>::infinity();

Measurement first_order(int n) {
    return Measurement(1.0 / n).error("T", Norm::L2, 1.0 / n).value("T_s", 1.0 + 1.0 / n);
}

/// Two gates that pass and one that cannot; one study that covers "heat".
Verification some() {
    Study study("bar");
    study.refines("cells", {8, 16, 32}).measure(first_order);
    study.gate("T", Norm::L2, expect(1.0).or_better(0.1), "1/n")
        .limit_bound("T_s", 1.0, at_most(1.001), "1 + 1/n tends to 1")
        .gate("T", Norm::L1, expect(1.0).within(0.1), "never measured");
    Verification v;
    v.manifest = R"({"revision":"abc"})";
    v.terms = {"heat", "stress"};
    v.studies = {
        {.name = "bar", .entry = "rod", .page = "# Bar", .covers = {"heat"}, .grids = {8, 16, 32}}};
    v.gates = run(study);
    return v;
}

TEST(CoverageOf, NamesEveryGap) {
    const Coverage full({"heat", "stress"}, {{"a", {"heat"}}, {"b", {"stress", "heat"}}});
    EXPECT_TRUE(full.gaps().empty());
    EXPECT_EQ(full.count("heat"), 2U);
    const Coverage holes({"heat", "stress"}, {{"a", {"heet"}}, {"b", {}}});
    EXPECT_THAT(holes.gaps(),
                ElementsAre("no study covers \"heat\"", "no study covers \"stress\"",
                            "study \"a\" covers \"heet\", which is no term of the model",
                            "study \"b\" does not say what it covers"));
}

TEST(Verification, FallsShortByAGateOrByAGapButByAGapOnlyIfWhole) {
    auto v = some();
    EXPECT_TRUE(v.fell_short());
    EXPECT_FALSE(v.passed());
    EXPECT_THAT(v.summary(), HasSubstr("2 pass, 1 fail\nFAIL: bar: T, L1: no error from grid 8"));
    EXPECT_THAT(v.summary(), Not(HasSubstr("no study covers")));

    v.gates.pop_back();
    EXPECT_FALSE(v.fell_short());
    EXPECT_TRUE(v.passed());
    v.whole = true;
    EXPECT_TRUE(v.fell_short());
    EXPECT_FALSE(v.passed());
    EXPECT_THAT(v.summary(), HasSubstr("FAIL: no study covers \"stress\""));

    v.terms = {"heat"};
    EXPECT_TRUE(v.passed());
    v.gates.clear();
    EXPECT_TRUE(v.fell_short()) << "nothing was shown";
}

TEST(Verification, IsNoneWhereGatesWereLeftOut) {
    auto v = some();
    v.gates.pop_back();
    leave_ungated(v.gates[0], {64});
    EXPECT_FALSE(v.fell_short());
    EXPECT_FALSE(v.passed());
    EXPECT_THAT(v.summary(), HasSubstr("1 pass, 0 fail, 1 not gated: too few grids"));
    EXPECT_THAT(v.summary(), HasSubstr("no verification"));
}

class VerificationFile : public testing::Test {
protected:
    const Scratch scratch_;
    const std::filesystem::path file_ = scratch_.path() / "verify.json";

    std::string refusal() const {
        try {
            read_verification(file_);
        } catch (const InputError& problem) {
            return problem.what();
        }
        return "read";
    }
};

TEST_F(VerificationFile, HoldsOneObjectForEachGate) {
    write(file_, some());
    const auto read = nlohmann::json::parse(std::ifstream(file_));
    EXPECT_EQ(read["revision"], "abc");
    EXPECT_EQ(read["passed"], false);
    ASSERT_EQ(read["gates"].size(), 3U);
    for (const char* key :
         {"study", "quantity", "norm", "grids", "h", "errors", "pairwise_orders", "fit", "expected",
          "tolerance", "reason", "uncertainty", "verdict", "passed", "seconds"})
        EXPECT_TRUE(read["gates"][0].contains(key)) << key;
    EXPECT_NEAR(read["gates"][0]["fit"].get<double>(), 1.0, 1e-12);
    EXPECT_TRUE(read["gates"][0]["tolerance"]["above"].is_null()) << "or better";
    EXPECT_NEAR(read["gates"][1]["uncertainty"].get<double>(), 1.25 / 32, 1e-12);
    EXPECT_TRUE(read["gates"][2]["fit"].is_null()) << "NaN";
}

TEST_F(VerificationFile, ReadsBackAsItWasWritten) {
    const auto v = some();
    write(file_, v);
    const auto back = read_verification(file_);
    EXPECT_EQ(back.manifest, v.manifest);
    EXPECT_EQ(back.terms, v.terms);
    EXPECT_EQ(back.studies.at(0).page, "# Bar");
    EXPECT_EQ(back.studies.at(0).covers, v.studies[0].covers);
    EXPECT_EQ(back.summary(), v.summary());
    EXPECT_EQ(back.gates.at(0).above, infinity);
    EXPECT_EQ(back.gates.at(1).low, -infinity);
    EXPECT_EQ(back.gates.at(1).values, v.gates[1].values);
    EXPECT_EQ(back.gates.at(1).limit.uncertainty, v.gates[1].limit.uncertainty);
    EXPECT_TRUE(std::isnan(back.gates.at(2).fit));
    // What is written of it is the same again.
    const auto first = nlohmann::json::parse(std::ifstream(file_));
    write(file_, back);
    EXPECT_EQ(nlohmann::json::parse(std::ifstream(file_)), first);
}

TEST_F(VerificationFile, SaysWhatIsWrongWithIt) {
    EXPECT_THAT(refusal(), HasSubstr("verify.json cannot be read"));
    std::filesystem::create_directories(file_.parent_path());
    std::ofstream(file_) << "{\"whole\": true}";
    EXPECT_THAT(refusal(), HasSubstr("terms"));
    std::ofstream(file_) << "half a fi";
    EXPECT_THAT(refusal(), HasSubstr("parse error"));
}

/// The page goes along them side by side.
TEST_F(VerificationFile, WhoseListsDifferInLengthIsRefused) {
    write(file_, some());
    const auto whole = nlohmann::json::parse(std::ifstream(file_));
    for (const char* list : {"grids", "h", "errors", "pairwise_orders"})
        for (const bool shorter : {true, false}) {
            auto damaged = whole;
            auto& gate = damaged.at("gates").at(0).at(list);
            if (shorter)
                gate.erase(0);
            else
                gate.push_back(gate.at(0));
            std::ofstream(file_) << damaged.dump();
            EXPECT_THAT(refusal(), HasSubstr("do not fit together")) << list << shorter;
        }
}

}  // namespace
}  // namespace crawford::reports
