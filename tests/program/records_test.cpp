/// What `crawford verify` keeps and when it trusts it.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class ProgramRecords : public ProgramTest {
protected:
    Finished verify(const std::string& program, std::vector<std::string> more = {}) const {
        std::vector<std::string> command{program, "verify"};
        const std::vector<std::string> studies{"slab-burning-law", "heat-time"};
        command.insert(command.end(), studies.begin(), studies.end());
        command.insert(command.end(), {"--out", out_.string()});
        command.insert(command.end(), more.begin(), more.end());
        return run_program(command);
    }

    std::vector<json> records() const {
        std::vector<json> all;
        for (const auto& file : fs::directory_iterator(out_ / "records")) {
            std::ifstream in(file.path());
            for (std::string line; std::getline(in, line);) all.push_back(json::parse(line));
        }
        return all;
    }
    std::set<std::string> fingerprints() const {
        std::set<std::string> all;
        for (const auto& record : records()) all.insert(record.at("fingerprint"));
        return all;
    }
    json report() const { return json::parse(std::ifstream(out_ / "verify.json")); }
};

TEST_F(ProgramRecords, AreMadeOnceAndJudgedAgain) {
    const Finished first = verify(program_path());
    EXPECT_EQ(first.status, 0) << first.output;
    EXPECT_THAT(first.output, HasSubstr("done in"));
    for (const auto& record : records())
        for (const char* member :
             {"experiment", "setting", "quantities", "cost", "outcome", "fingerprint"})
            EXPECT_TRUE(record.contains(member)) << member;
    const json gates = report().at("gates");

    const Finished second = verify(program_path());
    EXPECT_EQ(second.status, 0) << second.output;
    EXPECT_THAT(second.output, Not(HasSubstr("done in")));
    EXPECT_EQ(report().at("gates"), gates);

    const Finished judged = verify(program_path(), {"--judge-only"});
    EXPECT_EQ(judged.status, 0) << judged.output;
    EXPECT_EQ(report().at("gates"), gates);
}

TEST_F(ProgramRecords, OfOneProgramDoNotTurnAnotherGreen) {
    EXPECT_EQ(verify(program_path()).status, 0);
    const auto before = records();
    const auto sound = fingerprints();
    ASSERT_EQ(sound.size(), 1U);

    const Finished altered = verify(altered_program_path());
    EXPECT_EQ(altered.status, 1) << altered.output;
    EXPECT_THAT(altered.output, HasSubstr("FAIL: slab-burning-law, AP: "));
    EXPECT_FALSE(report().at("passed").get<bool>());
    EXPECT_EQ(records().size(), before.size()) << "every run was made anew";
    EXPECT_EQ(fingerprints().size(), 1U);
    EXPECT_NE(fingerprints(), sound);
}

TEST_F(ProgramRecords, OfAnotherProgramAreJudgedOnlyWithAWord) {
    verify(altered_program_path());
    const Finished judged = verify(program_path(), {"--judge-only"});
    EXPECT_EQ(judged.status, 1) << judged.output;
    EXPECT_THAT(judged.output, HasSubstr("crawford: remark: records are of another build"));
}

TEST_F(ProgramRecords, ThatAreMissingLeaveGatesUngated) {
    verify(program_path());
    fs::remove_all(out_ / "records");
    const Finished judged = verify(program_path(), {"--judge-only"});
    EXPECT_EQ(judged.status, 0) << judged.output;
    EXPECT_THAT(judged.output, HasSubstr("no verification"));
    EXPECT_FALSE(report().at("passed"));
}

TEST_F(ProgramRecords, OfOneAxisAreMadeByItsName) {
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> command{program_path(), "verify", "slab-burning-law",
                                         "--quiet",      "--out",  out_.string()};
        command.insert(command.end(), more.begin(), more.end());
        return run_program(command);
    };
    EXPECT_EQ(run({"--axis", "rows=32"}).status, 0);
    for (const auto& record : records()) EXPECT_EQ(record.at("setting").at("rows"), 32);
    for (const char* wrong : {"columns=32", "rows", "rows=", "=32", "rows=many", "rows=0"})
        EXPECT_EQ(run({"--axis", wrong}).status, 2) << wrong;
    EXPECT_THAT(run({"--axis", "columns=32"}).output, HasSubstr("choose one of rows"));
    EXPECT_EQ(run({"--axis", "rows=32", "--grids", "32"}).status, 2);
}

TEST_F(ProgramRecords, GridsDoNotSayWhichOfSeveralAxes) {
    const Finished refused = run_program({program_path(), "verify", "sandwich-refinement",
                                          "--grids", "32,64", "--out", out_.string()});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.output, HasSubstr("refines steps, rows, columns"));
    EXPECT_THAT(refused.output, HasSubstr("--axis"));
    EXPECT_FALSE(fs::exists(out_)) << "refused before anything is written";
}

}  // namespace
}  // namespace crawford
