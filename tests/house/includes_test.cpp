// Who may know whom. solver and reference must not share a line of code, or the truth could not
// disagree with what it judges; reports knows neither. Within solver/ the order is that of a run,
// from plain data upward, and no folder anywhere is part of a cycle.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/scratch.hpp"
#include "base/source_tree.hpp"
#include "include_graph.hpp"

namespace crawford::house {

namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Rules rules() {
    const Names below_cases{"base", "solver", "reference", "reports"};
    Rules rules;
    rules.may_know = {{"base", {"base"}},
                      {"solver", {"base", "solver"}},
                      {"reference", {"base", "reference"}},
                      {"reports", {"base", "reports"}},
                      {"cases", below_cases},
                      {"program", below_cases},
                      {"tests", below_cases}};
    rules.may_know["cases"].insert("cases");
    rules.may_know["program"].insert({"cases", "program"});
    rules.may_know["tests"].insert("tests");
    // One burns what a study burns, one asks cases for their claims: a program of their own.
    rules.may_know["tests/handed_in"] = {"base", "cases", "tests"};
    rules.may_know["tests/ledger"] = {"base", "cases", "tests"};
    // Programs of their own, which take the readers of files out of any folder.
    rules.may_know["tests/fuzz"] = {"base", "solver", "reports", "program", "tests"};
    rules.ranks = {{"packing", "linear_solvers", "time_integration"},
                   {"scene"},
                   {"mesh"},
                   {"materials"},
                   {"element"},
                   {"burning"},
                   {"heat", "stress", "projection", "reference_map"},
                   {"step"},
                   {"guards"},
                   {"files"},
                   {"run"}};
    rules.lean = {"solver", "reference", "reports"};
    return rules;
}

TEST(Includes, OfThisTreeAreAllowed) {
    Rules ours = rules();
    // These wrap a library for their own folder.
    ours.wrappers = {"reference/derivatives.hpp", "reference/root.hpp",
                     "solver/files/hdf5_file.hpp", "solver/scene/overrides.hpp",
                     "solver/scene/toml_table.hpp"};
    // Private to their folder: only its .cpp files include them.
    for (const char* json : {"failure", "figure", "gate", "order", "record"})
        ours.wrappers.insert(fmt::format("reports/{}_json.hpp", json));
    for (const std::string& complaint : complaints(source_path("."), ours))
        ADD_FAILURE() << complaint;
}

TEST(Headers, SayFirstWhatTheyAreFor) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_path("."))) {
        const auto folder = relative(entry.path(), source_path(".")).begin()->string();
        if (entry.path().extension() != ".hpp" || !rules().may_know.contains(folder)) continue;
        std::string first;
        std::getline(std::ifstream(entry.path()), first);
        EXPECT_THAT(first, HasSubstr("///")) << entry.path();
    }
}

// Tests run side by side: two that share a file fail now and then.
TEST(Tests, MakeFilesOnlyInADirectoryThatNobodyElseHas) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_path("tests"))) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (const std::string& shared :
             {std::string("Temp") + "Dir", std::string("temp_") + "dir"})
            EXPECT_THAT(text, Not(HasSubstr(shared)))
                << entry.path() << ": base/scratch.hpp has one";
    }
}

TEST(Includes, AreRead) {
    EXPECT_GT(includes_of(source_path("."), rules()).size(), 1000u);
}

/// A small tree.
class IncludesOf : public ::testing::Test {
protected:
    void put(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << "#pragma once\n" << text << '\n';
    }
    std::vector<std::string> found() const { return complaints(root_, rules()); }
    void expect(const std::string& complaint, const std::string& file, const std::string& text) {
        put(file, text);
        EXPECT_THAT(found(), Contains(HasSubstr(complaint))) << file << ": " << text;
        std::filesystem::remove_all(root_);
    }
    void expect_fine(const std::string& file, const std::string& text) {
        put(file, text);
        EXPECT_THAT(found(), IsEmpty()) << file << ": " << text;
        std::filesystem::remove_all(root_);
    }

private:
    const Scratch scratch_;
    const std::filesystem::path root_ = scratch_.path() / "tree";
};

TEST_F(IncludesOf, WhatIsAllowedPass) {
    expect_fine("solver/heat/b.hpp", "#include \"solver/heat/c.hpp\"");
    expect_fine("solver/heat/b.hpp", "#include \"solver/mesh/grid.hpp\"");
    expect_fine("solver/heat/b.cpp", "#include <Eigen/Core>  // not \"reference/slab.hpp\"");
    expect_fine("solver/heat/b.cpp", "#include <fmt/format.h>");
    expect_fine("solver/heat/b.hpp", "#include <vector>");
    expect_fine("cases/a.cpp", "#include \"reference/slab.hpp\"");
    expect_fine("tests/a_test.cpp", "#include \"solver/heat/b.hpp\"");
    expect_fine("tests/a_test.cpp", "#include \"helper.hpp\"");
}

TEST_F(IncludesOf, ForbiddenFoldersAreSeen) {
    expect("solver/ may not know reference/", "solver/heat/b.hpp", "#include \"reference/s.hpp\"");
    expect("reference/ may not know solver/", "reference/s.cpp", "#include \"solver/heat/b.hpp\"");
    expect("reports/ may not know solver/", "reports/o.hpp", "#include \"solver/heat/b.hpp\"");
    expect("reports/ may not know reference/", "reports/o.hpp", "#include \"reference/s.hpp\"");
    expect("solver/ may not know reports/", "solver/heat/b.cpp", "#include \"reports/o.hpp\"");
    expect("reference/ may not know reports/", "reference/s.cpp", "#include \"reports/o.hpp\"");
    expect("solver/ may not know cases/", "solver/heat/b.cpp", "#include \"cases/case.hpp\"");
    expect("solver/ may not know tests/", "solver/heat/b.cpp", "#include \"tests/helper.hpp\"");
    expect("base/ may not know solver/", "base/b.cpp", "#include \"solver/heat/b.hpp\"");
    expect("cases/ may not know program/", "cases/b.cpp", "#include \"program/b.hpp\"");
    expect("tests/ may not know program/", "tests/b.cpp", "#include \"program/b.hpp\"");
    expect("may not know reference/", "solver/heat/b.cpp", "  #  include   \"reference/s.hpp\"");
    expect("may not know reference/", "solver/heat/b.cpp.in", "#include \"reference/s.hpp\"");
}

TEST_F(IncludesOf, TheOrderWithinTheSolverIsKept) {
    expect("solver/mesh/ may not know solver/heat/", "solver/mesh/b.hpp",
           "#include \"solver/heat/b.hpp\"");
    expect("solver/heat/ may not know solver/stress/", "solver/heat/b.hpp",
           "#include \"solver/stress/b.hpp\"");
    expect("solver/files/ may not know solver/run/", "solver/files/b.hpp",
           "#include \"solver/run/b.hpp\"");
    expect("solver/new/ has no rank", "solver/new/b.hpp", "#include \"solver/mesh/b.hpp\"");
}

TEST_F(IncludesOf, OtherSpellingsAreSeen) {
    expect("names no folder", "solver/heat/b.cpp", "#include \"c.hpp\"");
    expect("angle brackets", "solver/heat/b.cpp", "#include <reference/slab.hpp>");
    expect("is relative", "solver/heat/b.cpp", "#include \"../../reference/slab.hpp\"");
    expect("is relative", "solver/heat/b.cpp", "#include \"solver/../reference/slab.hpp\"");
    expect("is neither", "solver/heat/b.cpp", "#include HEADER");
}

TEST_F(IncludesOf, CyclesOfFoldersAreSeen) {
    put("cases/verify/a.hpp", "#include \"cases/scenes/b.hpp\"");
    put("cases/scenes/b.hpp", "#include \"cases/paper/c.hpp\"");
    EXPECT_THAT(found(), IsEmpty());
    put("cases/paper/c.cpp", "#include \"cases/verify/a.hpp\"");
    EXPECT_THAT(
        found(),
        Contains(HasSubstr("a cycle of folders: cases/paper -> cases/verify -> cases/scenes")));
}

TEST_F(IncludesOf, HeadersThatBringALibraryAreSeen) {
    expect("users of this header need it too", "solver/heat/b.hpp", "#include <fmt/format.h>");
    expect("users of this header need it too", "reports/b.hpp", "#include <nlohmann/json.hpp>");
    expect("users of this header need it too", "reference/b.hpp", "#include <hdf5.h>");
}

}  // namespace

}  // namespace crawford::house
