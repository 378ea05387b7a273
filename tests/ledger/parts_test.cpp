/// The ledger of some figures: the same rows as in that of all, from no more runs than they rest on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/scratch.hpp"
#include "cases/paper/ledger/ledger.hpp"
#include "cases/paper/ledger/packs.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/paper/ledger/refinements.hpp"

namespace crawford::ledger {
namespace {

/// A number made up, another one for each name.
double made_up(const std::string& name) {
    return 1.0 + 1e-4 * double(std::hash<std::string>()(name) % 10000);
}

/// All that any run may be asked for.
std::vector<std::string> all_quantities() {
    std::vector<std::string> all;
    for (const Readings& readings :
         {pack_readings(Fidelity::draft), sandwich_readings(Fidelity::draft)})
        for (const auto& quantity : readings.quantities) all.push_back(quantity.name);
    for (const auto& measures : {pack_measures(), rigid_pack_measures(), sandwich_measures(),
                                 rigid_sandwich_measures()})
        for (const Measure& measure : measures) {
            all.push_back(measure.what);
            for (const char* of : {of_pack, of_pack_2Q, of_rigid_pack})
                all.push_back(spread_name(of, measure));
        }
    return all;
}

/// The record of a run that is among `runs`.
reports::Record record_among(const std::vector<Run>& runs, const Run& run) {
    const auto is_it = [&](const Run& one) {
        return one.experiment == run.experiment && one.setting.text() == run.setting.text();
    };
    if (std::ranges::none_of(runs, is_it))
        throw std::logic_error("judged by " + run.experiment + ", which is not among its runs");
    reports::Record record{.experiment = run.experiment, .setting = run.setting};
    record.found.emplace();
    for (const std::string& quantity : all_quantities())
        if (!record.found->value_of(quantity))
            record.found->value(quantity, made_up(run.setting.text() + quantity));
    return record;
}

/// As written, so that every number is compared to its last digit.
std::string rows_of(const std::vector<const Entry*>& cases, const std::string& entry) {
    const auto runs = ledger::runs(Fidelity::draft, cases);
    const auto ledger = judged(
        Fidelity::draft, cases, [&](const Run& run) { return record_among(runs, run); },
        [](const std::string& name, const std::string& what) { return made_up(name + what); });
    const Scratch scratch;
    const auto file = scratch.path() / "ledger.json";
    reports::write(file, ledger);
    std::ifstream stream(file);
    std::string rows;
    for (const auto& row : nlohmann::json::parse(stream).at("rows"))
        if (row.at("entry") == entry) rows += row.dump() + '\n';
    return rows;
}

TEST(LedgerParts, HaveTheRowsOfTheWhole) {
    const auto all = claiming_cases();
    ASSERT_GE(all.size(), 12U);
    for (const Entry* entry : all) {
        const std::string rows = rows_of({entry}, entry->name);
        EXPECT_FALSE(rows.empty()) << entry->name;
        EXPECT_EQ(rows, rows_of(all, entry->name)) << entry->name;
    }
}

TEST(LedgerParts, NeedNoRunOfOthers) {
    const auto all = claiming_cases();
    const auto runs_of = [](const std::vector<const Entry*>& cases) {
        return runs(Fidelity::draft, cases).size();
    };
    size_t none = 0;
    for (const Entry* entry : all) {
        EXPECT_LT(runs_of({entry}), runs_of(all)) << entry->name;
        if (runs_of({entry}) == 0) ++none;
    }
    EXPECT_EQ(none, std::ranges::count(all, LedgerRuns::none, &Entry::claims_rest_on));
    EXPECT_GT(none, 0U);
}

}  // namespace
}  // namespace crawford::ledger
