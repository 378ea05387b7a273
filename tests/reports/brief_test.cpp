#include "reports/brief.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <filesystem>
#include <sstream>
#include <string>

#include "base/scratch.hpp"
#include "reports/judgement.hpp"
#include "reports/junit.hpp"

namespace crawford::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

GateResult gate(const std::string& study, const std::string& quantity, double value) {
    auto result =
        judge(Bound{quantity, between(0.0, 1.0), "because of <the model> & \"more\""}, value);
    result.study = study;
    return result;
}

/// One study that passes, one that fails, one that was not gated, one that was not run.
Verification some() {
    Verification v;
    for (const char* name : {"heat", "slab, AP, beta = 3 alpha K", "quick", "idle"})
        v.studies.push_back({.name = name, .seconds = 12.34});
    v.gates = {gate("heat", "T [K]", 0.5), gate("heat", "q", 0.25),
               gate("slab, AP, beta = 3 alpha K", "T < 1 & \"so\" on [K]", 2.0),
               gate("slab, AP, beta = 3 alpha K", "u", 0.5), gate("quick", "T", 0.5)};
    leave_ungated(v.gates.back(), {128});
    return v;
}

TEST(Brief, HasALineForEachStudyAndGatesThatFellShortInFull) {
    const auto text = brief(some());
    std::istringstream lines(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    ASSERT_GE(all.size(), 4U);
    EXPECT_THAT(all[0], testing::MatchesRegex("heat +2/2 +pass +12.3 CPU s"));
    EXPECT_THAT(all[1],
                testing::MatchesRegex("slab, AP, beta = 3 alpha K +1/2 +1 FAIL +12.3 CPU s"));
    EXPECT_THAT(all[2], testing::MatchesRegex("quick +0/1 +not gated +12.3 CPU s"));
    EXPECT_THAT(all[3], testing::MatchesRegex("idle +0/0 +not run +12.3 CPU s"));
    EXPECT_THAT(text, HasSubstr(table({some().gates[2]})));
    EXPECT_THAT(text, Not(HasSubstr("T [K]")));
}

TEST(Brief, StaysWithinEightyColumns) {
    Verification v;
    v.studies.push_back({.name = std::string(79, 'n'), .seconds = 9999.9});
    v.studies.push_back({.name = std::string(52, 'n'), .seconds = 9999.9});
    for (int i = 0; i < 200; ++i) {
        v.gates.push_back(gate(v.studies[0].name, "q", 0.5));
        leave_ungated(v.gates.back(), {1});
    }
    std::istringstream lines(brief(v));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

using Element = boost::property_tree::ptree;

/// The file of some results, read back.
Element written(const Verification& v) {
    const Scratch scratch;
    const auto file = scratch.path() / "junit.xml";
    write_junit(file, v);
    Element document;
    boost::property_tree::read_xml(file.string(), document,
                                   boost::property_tree::xml_parser::trim_whitespace);
    return document.get_child("testsuites");
}

TEST(Junit, TellsGatesOfOneQuantityApartByTheirGrids) {
    Verification v;
    v.studies.push_back({.name = "heat", .seconds = 1.0});
    std::vector<Level> levels;
    for (const int n : {16, 32, 64, 128}) levels.push_back({n, 1.0 / n, 1.0 / (n * n)});
    for (const int last : {64, 128}) {
        v.gates.push_back(judge(Gate{"T", Norm::L2, expect(2.0).within(0.1).to(last), "bilinear"},
                                Convergence(levels), {16, 32, 64, 128}));
        v.gates.back().study = "heat";
    }
    std::vector<std::string> names;
    for (const auto& [kind, suite] : written(v))
        for (const auto& [what, test] : suite)
            if (what == "testcase") names.push_back(test.get<std::string>("<xmlattr>.name"));
    EXPECT_THAT(names, testing::ElementsAre("T, L2, grids 16 to 64, order 2",
                                            "T, L2, grids 16 to 128, order 2"));
}

TEST(Junit, HasASuiteAStudyAndATestAGate) {
    const auto suites = written(some());
    std::vector<std::string> names, tests, failed, skipped;
    for (const auto& [kind, suite] : suites) {
        if (kind != "testsuite") continue;
        names.push_back(suite.get<std::string>("<xmlattr>.name"));
        for (const auto& [what, test] : suite) {
            if (what != "testcase") continue;
            EXPECT_EQ(test.get<std::string>("<xmlattr>.classname"), names.back());
            const auto name = test.get<std::string>("<xmlattr>.name");
            tests.push_back(name);
            if (test.count("failure") > 0) failed.push_back(name);
            if (test.count("skipped") > 0) skipped.push_back(name);
        }
    }
    EXPECT_THAT(names, testing::ElementsAre("heat", "slab, AP, beta = 3 alpha K", "quick", "idle"));
    EXPECT_EQ(tests.size(), 5U);
    EXPECT_THAT(failed, testing::ElementsAre("T < 1 & \"so\" on [K]")) << "read back as it was";
    EXPECT_THAT(skipped, testing::ElementsAre("T"));
}

TEST(Junit, SaysOfAFailureAllThatIsKnown) {
    auto v = some();
    v.gates[2].failure += "\x01";
    std::string text;
    for (const auto& [kind, suite] : written(v))
        for (const auto& [what, test] : suite)
            if (test.count("failure") > 0) text = test.get<std::string>("failure");
    EXPECT_THAT(text, HasSubstr("2 is outside [0, 1]?")) << "a control character is no XML";
    EXPECT_THAT(text, HasSubstr("because of <the model> & \"more\""));
}

TEST(Junit, FailsWithTheCoverage) {
    auto v = some();
    v.whole = true;
    v.terms = {"conduction"};
    const auto suites = written(v);
    ASSERT_FALSE(suites.empty());
    const Element& last = suites.back().second;
    EXPECT_EQ(last.get<std::string>("<xmlattr>.name"), "coverage");
    EXPECT_GE(last.get<int>("<xmlattr>.failures"), 1);
}

}  // namespace
}  // namespace crawford::reports
