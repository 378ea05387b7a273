/// `crawford verify --against`: what it says and how it ends.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class ProgramAgainst : public ProgramTest {
protected:
    ProgramAgainst() { fs::create_directories(out_); }
    Finished verify(const std::vector<std::string>& more) const {
        std::vector<std::string> command{program_path(), "verify", "slab-burning-law",
                                         "--quiet",      "--out",  new_run()};
        command.insert(command.end(), more.begin(), more.end());
        return run_program(command);
    }
    std::string new_run() const { return (out_ / "new").string(); }
    std::string old() const { return (out_ / "old.json").string(); }

    /// This run as the earlier one, its first gate's finest error changed by a factor.
    void keep(double factor) const {
        auto document = json::parse(std::ifstream(out_ / "new" / "verify.json"));
        for (json& gate : document.at("gates"))
            if (gate.at("kind") == "order") {
                json& error = gate.at("errors").back();
                error = error.get<double>() * factor;
                break;
            }
        std::ofstream(old()) << document;
    }

    void expect_refused(const std::vector<std::string>& more, const std::string& message) const {
        const Finished run = verify(more);
        EXPECT_EQ(run.status, 2) << run.output;
        EXPECT_THAT(run.output, HasSubstr(message));
        EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
        EXPECT_FALSE(fs::exists(new_run())) << "refused before anything is run";
    }
};

TEST_F(ProgramAgainst, RefusesBeforeItRuns) {
    expect_refused({"--against", old()}, old());
    std::ofstream(old()) << R"({"gates": [)";
    expect_refused({"--against", old()}, old());
    std::ofstream(old()) << R"({"gates": []})";
    expect_refused({"--against", old(), "--grown", "0.5"}, "--grown = 0.5");
    expect_refused({"--against", old(), "--grown", "nan"}, "--grown");
    expect_refused({"--grown", "1.1"}, "--against");
    expect_refused({"--exact"}, "--against");
}

TEST_F(ProgramAgainst, HoldsARunAgainstAnEarlierOne) {
    ASSERT_EQ(verify({}).status, 0);
    keep(1.0);
    const Finished same = verify({"--judge-only", "--against", old(), "--exact"});
    EXPECT_EQ(same.status, 0) << same.output;
    EXPECT_THAT(same.output, HasSubstr("all the same"));

    keep(1.0 / 3.0);
    const Finished grown = verify({"--judge-only", "--against", old()});
    EXPECT_EQ(grown.status, 1) << grown.output;
    EXPECT_THAT(grown.output, HasSubstr("grown: slab-burning-law"));
    EXPECT_EQ(verify({"--judge-only", "--against", old(), "--grown", "3.5"}).status, 0);

    keep(1.0000001);
    EXPECT_EQ(verify({"--judge-only", "--against", old()}).status, 0);
    const Finished other = verify({"--judge-only", "--against", old(), "--exact"});
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(other.output, HasSubstr("other: slab-burning-law"));
}

TEST_F(ProgramAgainst, PrintsALineAStudyAndAllWhereAsked) {
    const auto junit = out_ / "made" / "junit.xml";
    const Finished short_one = verify({"--junit", junit.string()});
    EXPECT_THAT(short_one.output, HasSubstr("  pass "));
    EXPECT_THAT(short_one.output, testing::Not(HasSubstr("because")));
    EXPECT_TRUE(fs::exists(junit));
    EXPECT_THAT(verify({"--judge-only", "--verbose"}).output, HasSubstr("because"));
    const Finished refused = verify({"--junit", "/dev/null/junit.xml"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.output, HasSubstr("/dev/null"));
}

}  // namespace
}  // namespace crawford
