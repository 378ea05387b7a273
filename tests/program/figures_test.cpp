/// Figures as a user draws them again: what is up to date stays, what was cut off goes on. Every
/// test runs the built `crawford`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"
#include "tests/program_path.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A directory of the test's own.
class ProgramFigures : public testing::Test {
protected:
    Finished draw(const std::string& name, const std::string& out,
                  std::vector<std::string> options = {}) const {
        std::vector<std::string> command = {
            program_path(), "run", name, "--fidelity", "draft", "--out", (scratch_ / out).string()};
        command.insert(command.end(), options.begin(), options.end());
        return run_program(command);
    }

    const Scratch own_;
    const fs::path scratch_ = own_.path();
};

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> names(const fs::path& directory) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(directory))
        names.insert(fs::relative(entry.path(), directory).string());
    return names;
}

TEST_F(ProgramFigures, AreNotDrawnWhileTheyAreUpToDate) {
    draw("fig01", "out");
    const fs::path picture = scratch_ / "out" / "figures" / "fig01a.svg";
    const auto drawn = fs::last_write_time(picture);

    const Finished second = draw("fig01", "out");
    EXPECT_EQ(second.status, 0);
    EXPECT_THAT(second.output, HasSubstr("fig01: up to date"));
    EXPECT_THAT(second.output, HasSubstr("height of the cells at the surface"))
        << "what it has found is told all the same";
    EXPECT_EQ(fs::last_write_time(picture), drawn);

    EXPECT_THAT(draw("fig01", "out", {"--again"}).output, Not(HasSubstr("up to date")));
    EXPECT_NE(fs::last_write_time(picture), drawn);
}

TEST_F(ProgramFigures, AreDrawnAnewWhereAFileIsMissing) {
    draw("fig01", "out");
    for (const char* file : {"fig01b.svg", "fig01_nodes.csv", "fig01_manifest.json"}) {
        fs::remove(scratch_ / "out" / "figures" / file);
        EXPECT_THAT(draw("fig01", "out").output, Not(HasSubstr("up to date"))) << file;
        EXPECT_TRUE(fs::exists(scratch_ / "out" / "figures" / file)) << file;
    }
}

TEST_F(ProgramFigures, AreDrawnAnewAtAnotherFidelity) {
    draw("fig01", "out");
    const Finished fine = draw("fig01", "out", {"--fidelity", "fine"});
    EXPECT_EQ(fine.status, 2) << "the option stands twice";
    const Finished paper =
        run_program({program_path(), "run", "fig01", "--out", (scratch_ / "out").string()});
    EXPECT_THAT(paper.output, Not(HasSubstr("up to date")));
}

/// A figure of lines and one with a map, drawn again from what they have left.
TEST_F(ProgramFigures, AreDrawnAgainFromTheirRecords) {
    for (const std::string name : {"fig01", "fig12"}) {
        draw(name, name);
        const fs::path figures = scratch_ / name / "figures";
        std::map<std::string, std::string> before;
        for (const std::string& file : names(figures)) {
            before[file] = content(figures / file);
            if (!file.ends_with(".csv") && !file.ends_with(".json")) fs::remove(figures / file);
        }
        const Finished again = run_program(
            {program_path(), "run", name, "--from-records", "--out", (scratch_ / name).string()});
        EXPECT_EQ(again.status, 0) << again.output;
        for (const auto& [file, bytes] : before) EXPECT_EQ(content(figures / file), bytes) << file;
    }
}

/// It looks at a burn and at nothing else: without the burn it is drawn all the same.
TEST_F(ProgramFigures, BurnNothingFromRecords) {
    draw("fig05", "out");
    const std::string before = content(scratch_ / "out" / "figures" / "fig05.svg");
    fs::remove_all(scratch_ / "out" / "burns");
    fs::remove(scratch_ / "out" / "figures" / "fig05.svg");
    EXPECT_EQ(draw("fig05", "out", {"--from-records"}).status, 0);
    EXPECT_EQ(content(scratch_ / "out" / "figures" / "fig05.svg"), before);
    EXPECT_FALSE(fs::exists(scratch_ / "out" / "burns"));
}

TEST_F(ProgramFigures, WithoutARecordAreRefused) {
    const auto refused = [&](const std::string& why, std::vector<std::string> options = {}) {
        options.insert(options.begin(), "--from-records");
        const Finished again = draw("fig01", "out", options);
        EXPECT_EQ(again.status, 2) << again.output;
        EXPECT_THAT(again.output, HasSubstr("fig01: " + why));
        EXPECT_THAT(again.output, HasSubstr("draw it first"));
    };
    refused("no record of a drawing");
    draw("fig01", "out");
    fs::remove(scratch_ / "out" / "figures" / "fig01_nodes.csv");
    refused((scratch_ / "out" / "figures" / "fig01_nodes.csv").string() + " is gone");
    run_program({program_path(), "run", "fig01", "--out", (scratch_ / "out").string()});
    refused("the record is of fidelity paper, not draft");
}

/// Two fidelities share their files: the record that is there is of those that are there.
TEST_F(ProgramFigures, AreNotTakenForThoseOfAnEarlierFidelity) {
    draw("fig12", "out");
    const fs::path numbers = scratch_ / "out" / "figures" / "fig12_fraction.csv";
    const std::string draft = content(numbers);
    run_program({program_path(), "run", "fig12", "--out", (scratch_ / "out").string()});
    EXPECT_NE(content(numbers), draft);
    EXPECT_THAT(draw("fig12", "out").output, Not(HasSubstr("up to date")));
    EXPECT_EQ(content(numbers), draft);
}

/// Figure 5 burns 30 ms with a checkpoint every 10 ms. It is killed after the first, and again
/// drawn ends in the same numbers, bit for bit, and in the same files.
TEST_F(ProgramFigures, GoOnWithABurnThatWasKilled) {
    draw("fig05", "whole");
    const std::string cut = (scratch_ / "cut").string();
    run_program({"sh", "-c",
                 program_path() + " run fig05 --fidelity draft --out " + cut + " & until ls " +
                     cut +
                     "/burns/*/burn_checkpoint_* >/dev/null 2>&1; do sleep 0.02; "
                     "done; kill -9 $!"});
    EXPECT_FALSE(fs::exists(scratch_ / "cut" / "figures" / "fig05_manifest.json"));
    std::ofstream(scratch_ / "cut" / "figures" / ".fig05a.svg.0123.part") << "half a picture";

    EXPECT_EQ(draw("fig05", "cut").status, 0);
    EXPECT_EQ(names(scratch_ / "cut"), names(scratch_ / "whole"));
    const fs::path burns = scratch_ / "whole" / "burns";
    int resumed = 0;
    for (const std::string& name : names(burns)) {
        const fs::path other = scratch_ / "cut" / "burns" / name;
        if (name.ends_with("_history.csv")) {
            EXPECT_EQ(content(burns / name), content(other)) << name;
        }
        if (name.ends_with("manifest.json"))
            resumed += content(other).find("restarted_from") != std::string::npos;
    }
    EXPECT_EQ(resumed, 1) << "it went on, and did not begin again";
    EXPECT_EQ(content(scratch_ / "whole" / "figures" / "fig05_surface.csv"),
              content(scratch_ / "cut" / "figures" / "fig05_surface.csv"));
}

}  // namespace
}  // namespace crawford
