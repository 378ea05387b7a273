#include "reports/ledger.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "base/errors.hpp"
#include "base/scratch.hpp"

namespace crawford::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One of each, with a run that failed, numbers that are missing and numbers of all 17 digits.
Ledger some() {
    Ledger ledger;
    ledger.manifest = R"({"revision":"abc","machine":{"cores":2}})";
    ledger.rows = {{.claim = "mean burn rate \"so\" < 1",
                    .where = "Fig. 15b",
                    .entry = "fig15",
                    .unit = "cm/s",
                    .paper = "0.42",
                    .ours = "0.416",
                    .paper_value = 0.42,
                    .value = 0.1 + 0.2,
                    .uncertainty = {.grid = 0.003, .packs = 0.004},
                    .reading = "as read",
                    .standing = Standing::reproduced,
                    .why = "Within 1 %."},
                   {.claim = "stress is confined to AP",
                    .standing = Standing::other_reading,
                    .why = "In words."}};
    ledger.readings = {{.title = "pack",
                        .grid = "60 x 48",
                        .quantities = {{"mean burn rate", "cm/s", 0.42}, {"peak", "%", {}}},
                        .runs = {{.reading = "as read", .values = {0.3, 1.0 / 3}, .distance = 0.01},
                                 {.reading = "alpha K",
                                  .set = {"numerics.thermal_stress=\"alpha K\""},
                                  .values = {nan, 2.0},
                                  .distance = nan,
                                  .failure = "diverged"}}}};
    ledger.refinements = {{.quantity = "mean burn rate",
                           .of = "pack",
                           .direction = "dt",
                           .unit = "cm/s",
                           .sizes = {50, 25},
                           .size_unit = "us",
                           .values = {0.41, nan},
                           .used = 25,
                           .order = 1.0,
                           .index = 2e-300,
                           .verdict = "monotone"}};
    ledger.spreads = {{.quantity = "mean burn rate",
                       .unit = "cm/s",
                       .seeds = {1, 18446744073709551615UL},
                       .values = {0.41, 0.43},
                       .mean = 0.42,
                       .deviation = 0.014}};
    return ledger;
}

TEST(LedgerUncertainty, IsTheRootOfTheSumOfSquaresOfWhatWasStudied) {
    EXPECT_DOUBLE_EQ(Uncertainty({.grid = 3.0, .packs = 4.0}).total().value(), 5.0);
    EXPECT_EQ(Uncertainty({.step = 0.0}).total(), 0.0);
    EXPECT_FALSE(Uncertainty{}.total().has_value());
}

class LedgerFile : public testing::Test {
protected:
    Json document() const { return Json::parse(std::ifstream(file_)); }

    /// What reading says of the document after `spoil` has been at it.
    std::string refusal(const std::function<void(Json&)>& spoil) const {
        write(file_, some());
        Json json = document();
        spoil(json);
        std::ofstream(file_) << json;
        return refusal();
    }
    std::string refusal() const {
        try {
            read_ledger(file_);
        } catch (const InputError& problem) {
            return problem.what();
        }
        return "read";
    }

    const Scratch scratch_;
    const std::filesystem::path file_ = scratch_.path() / "ledger.json";
};

TEST_F(LedgerFile, ReadsBackEveryNumberAndEveryWord) {
    const Ledger ledger = some();
    write(file_, ledger);
    const Ledger back = read_ledger(file_);
    EXPECT_EQ(back.manifest, ledger.manifest);
    ASSERT_EQ(back.rows.size(), 2U);
    const LedgerRow& row = back.rows[0];
    EXPECT_EQ(row.claim, ledger.rows[0].claim);
    EXPECT_EQ(row.where, "Fig. 15b");
    EXPECT_EQ(row.entry, "fig15");
    EXPECT_EQ(row.unit, "cm/s");
    EXPECT_EQ(row.paper, "0.42");
    EXPECT_EQ(row.ours, "0.416");
    EXPECT_EQ(row.paper_value, 0.42);
    EXPECT_EQ(row.value, 0.1 + 0.2) << "to the last bit";
    EXPECT_EQ(row.uncertainty.grid, 0.003);
    EXPECT_EQ(row.uncertainty.packs, 0.004);
    EXPECT_EQ(row.reading, "as read");
    EXPECT_EQ(row.why, "Within 1 %.");
    EXPECT_EQ(back.rows[1].standing, Standing::other_reading);
    const ReadingMatrix& matrix = back.readings.at(0);
    EXPECT_EQ(matrix.title, "pack");
    EXPECT_EQ(matrix.grid, "60 x 48");
    EXPECT_EQ(matrix.quantities.at(0).name, "mean burn rate");
    EXPECT_EQ(matrix.quantities[0].unit, "cm/s");
    EXPECT_EQ(matrix.quantities[0].paper, 0.42);
    EXPECT_THAT(matrix.runs.at(0).values, ElementsAre(0.3, 1.0 / 3));
    EXPECT_EQ(matrix.runs[0].distance, 0.01);
    EXPECT_EQ(matrix.runs.at(1).set, ledger.readings[0].runs[1].set);
    EXPECT_EQ(matrix.runs[1].failure, "diverged");
    const Refinement& refinement = back.refinements.at(0);
    EXPECT_EQ(refinement.of, "pack");
    EXPECT_EQ(refinement.direction, "dt");
    EXPECT_EQ(refinement.size_unit, "us");
    EXPECT_THAT(refinement.sizes, ElementsAre(50, 25));
    EXPECT_EQ(refinement.used, 25);
    EXPECT_EQ(refinement.order, 1.0);
    EXPECT_EQ(refinement.index, 2e-300);
    EXPECT_EQ(refinement.verdict, "monotone");
    const Spread& spread = back.spreads.at(0);
    EXPECT_EQ(spread.seeds, ledger.spreads[0].seeds);
    EXPECT_THAT(spread.values, ElementsAre(0.41, 0.43));
    EXPECT_EQ(spread.mean, 0.42);
    EXPECT_EQ(spread.deviation, 0.014);
    // What is written of it is the same again: nothing that is written is not read.
    const Json first = document();
    write(file_, back);
    EXPECT_EQ(document(), first);
}

TEST_F(LedgerFile, KeepsWhatIsMissingAndWhatIsNoNumber) {
    write(file_, some());
    const Ledger back = read_ledger(file_);
    EXPECT_FALSE(back.rows[0].uncertainty.step.has_value());
    EXPECT_FALSE(back.rows[1].value.has_value());
    EXPECT_FALSE(back.rows[1].paper_value.has_value());
    EXPECT_FALSE(back.readings[0].quantities[1].paper.has_value());
    EXPECT_TRUE(std::isnan(back.readings[0].runs[1].values[0]));
    EXPECT_TRUE(std::isnan(back.readings[0].runs[1].distance));
    EXPECT_TRUE(std::isnan(back.refinements[0].values[1]));
    EXPECT_FALSE(back.refinements[0].extrapolated.has_value());
    EXPECT_TRUE(document()["rows"][0]["uncertainty"]["step"].is_null());
}

TEST_F(LedgerFile, MayBeEmpty) {
    write(file_, Ledger{});
    EXPECT_TRUE(read_ledger(file_).rows.empty());
}

TEST_F(LedgerFile, SaysWhichMemberIsWrong) {
    EXPECT_THAT(refusal(), HasSubstr("ledger.json cannot be read"));
    const auto refused = [this](const char* message, const std::function<void(Json&)>& spoil) {
        EXPECT_THAT(refusal(spoil), HasSubstr(std::string("ledger.json: ") + message));
    };
    refused("rows is missing", [](Json& l) { l.erase("rows"); });
    refused("rows[1].why is missing", [](Json& l) { l["rows"][1].erase("why"); });
    refused("rows[0].uncertainty.grid is no number",
            [](Json& l) { l["rows"][0]["uncertainty"]["grid"] = "small"; });
    refused("rows[0].uncertainty is no object",
            [](Json& l) { l["rows"][0]["uncertainty"] = 0.01; });
    refused("rows[0].claim is no text", [](Json& l) { l["rows"][0]["claim"] = 1; });
    refused("rows[0].standing is \"perhaps\", none of \"reproduced\", \"reproduced under another",
            [](Json& l) { l["rows"][0]["standing"] = "perhaps"; });
    refused("readings is no list", [](Json& l) { l["readings"] = 1; });
    refused("readings[0].runs[1].values has 3 values for 2 quantities",
            [](Json& l) { l["readings"][0]["runs"][1]["values"].push_back(1.0); });
    refused("refinements[0].values has 1 values for 2 sizes",
            [](Json& l) { l["refinements"][0]["values"].erase(0); });
    refused("spreads[0].values has 3 values for 2 seeds",
            [](Json& l) { l["spreads"][0]["values"].push_back(1.0); });
    refused("spreads[0].seeds[0] is no whole number",
            [](Json& l) { l["spreads"][0]["seeds"][0] = -1; });
    refused("the document is no object", [](Json& l) { l = 3; });
    std::ofstream(file_) << "half a fi";
    EXPECT_THAT(refusal(), HasSubstr("parse error"));
}

}  // namespace
}  // namespace crawford::reports
