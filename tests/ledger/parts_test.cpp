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
std::vector<std::string> find_quantities() {
    std::vector<std::string> all;
    for (const Readings& readings :
         {pack_readings(Fidelity::draft), sandwich_readings(Fidelity::draft)})
        for (const auto& quantity : readings.quantities) all.push_back(quantity.name);
    for (const auto& measures :
         {pack_measures(), rigid_pack_measures(), sandwich_measures(), rigid_sandwich_measures()})
        for (const Measure& measure : measures) {
            all.emplace_back(measure.what);
            for (const char* of : {of_pack, of_pack_2Q, of_rigid_pack})
                all.push_back(spread_name(of, measure));
        }
    return all;
}

const std::vector<std::string>& all_quantities() {
    static const auto all = find_quantities();
    return all;
}

/// The record of a run that is among `runs`.
reports::Record record_among(const std::vector<Run>& runs, const Run& run) {
    const auto is_it = [&](const Run& one) {
        return one.experiment == run.experiment && one.setting.text() == run.setting.text();
    };
    if (std::ranges::none_of(runs, is_it))
        throw std::logic_error("judged by " + run.experiment + ", which is not among its runs");
    reports::Record record{.experiment = run.experiment, .setting = run.setting, .found = {}};
    record.found.emplace();
    for (const std::string& quantity : all_quantities())
        if (!record.found->value_of(quantity))
            record.found->value(quantity, made_up(run.setting.text() + quantity));
    return record;
}

/// The rows of a case, as written, so that every number is compared to its last digit.
std::string rows_of(const Entry& entry, const reports::Ledger& ledger) {
    const Scratch scratch;
    const auto file = scratch.path() / "ledger.json";
    reports::write(file, ledger);
    std::ifstream stream(file);
    const auto json = nlohmann::json::parse(stream);
    std::string rows;
    for (const auto& row : json.at("rows"))
        if (row.at("entry") == entry.name) rows += row.dump() + '\n';
    return rows;
}

reports::Ledger judged_alone(const std::vector<const Entry*>& cases, const std::vector<Run>& runs) {
    return judged(
        Fidelity::draft, cases, [&](const Run& run) { return record_among(runs, run); },
        [](const std::string& name, const std::string& what) { return made_up(name + what); });
}

TEST(LedgerParts, HaveTheRowsOfTheWholeByNoMoreRunsThanTheyNeed) {
    const auto all = claiming_cases();
    ASSERT_GE(all.size(), 12U);
    const auto all_runs = runs(Fidelity::draft, all);
    const auto whole = judged_alone(all, all_runs);
    for (const Entry* entry : all) {
        const auto its_runs = runs(Fidelity::draft, {entry});
        EXPECT_LT(its_runs.size(), all_runs.size()) << entry->name;
        EXPECT_EQ(its_runs.empty(), entry->claims_rest_on == LedgerRuns::none) << entry->name;
        const std::string rows = rows_of(*entry, judged_alone({entry}, its_runs));
        EXPECT_FALSE(rows.empty()) << entry->name;
        EXPECT_EQ(rows, rows_of(*entry, whole)) << entry->name;
    }
}

}  // namespace
}  // namespace crawford::ledger
