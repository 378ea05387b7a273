/// `crawford ledger --settle --figure`: a part of the ledger.

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ProgramLedger : public ProgramTest {
protected:
    Finished settle(const std::vector<std::string>& figures) const {
        std::vector<std::string> words{"ledger",  "--settle", "--fidelity", "draft",
                                       "--quiet", "--out",    out()};
        for (const std::string& figure : figures) {
            words.emplace_back("--figure");
            words.push_back(figure);
        }
        return crawford(words);
    }
    static nlohmann::json json_of(const fs::path& file) {
        std::ifstream stream(file);
        return nlohmann::json::parse(stream);
    }
    fs::path figures() const { return out_ / "figures"; }
};

TEST_F(ProgramLedger, SettlesTheClaimsOfTheFiguresThatAreNamed) {
    fs::create_directories(figures());
    fs::copy(source_path("results/ledger.json"), figures());
    const Finished run = settle({"fig12", "table1"});
    ASSERT_EQ(run.status, 0) << run.output;
    const fs::path file = figures() / "ledger-table1-fig12.json";
    EXPECT_THAT(run.output, HasSubstr(file.string()));
    const auto part = json_of(file);
    ASSERT_FALSE(part.at("rows").empty());
    for (const auto& row : part.at("rows"))
        EXPECT_THAT(row.at("entry").get<std::string>(), testing::AnyOf("table1", "fig12"));
    EXPECT_EQ(json_of(figures() / "ledger.json"), json_of(source_path("results/ledger.json")))
        << "it stays as it was";
}

TEST_F(ProgramLedger, RefusesWhatShowsNoClaim) {
    const std::vector<std::string> draft{"ledger", "--settle", "--out", out(), "--figure"};
    const auto with = [&](const std::string& figure) {
        auto words = draft;
        words.push_back(figure);
        return words;
    };
    expect_refused(with("fig99"), "no case is called fig99");
    expect_refused(with("fig02"), "no claim of the paper is judged by fig02");
    expect_refused({"ledger", "--figure", "fig12", "--out", out()}, "--settle");
    EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace crawford
