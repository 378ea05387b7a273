#include "cases/paper/ledger/ledger.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "cases/paper/ledger/packs.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/paper/ledger/refinements.hpp"

namespace crawford::ledger {

namespace {

using Cases = std::vector<const Entry*>;

bool rest_on(const Cases& cases, LedgerRuns runs) {
    return std::ranges::any_of(cases,
                               [&](const Entry* entry) { return entry->claims_rest_on == runs; });
}

std::vector<Series> series_of(Fidelity fidelity, const Cases& cases) {
    std::vector<Series> all;
    if (rest_on(cases, LedgerRuns::pack)) all = pack_series(fidelity);
    if (rest_on(cases, LedgerRuns::sandwich))
        std::ranges::move(sandwich_series(fidelity), std::back_inserter(all));
    return all;
}

Evidence evidence_of(Fidelity fidelity, const Cases& cases, const Records& records) {
    Evidence evidence;
    for (const Series& series : series_of(fidelity, cases))
        std::ranges::move(refinements(series, records), std::back_inserter(evidence.refinements));
    if (rest_on(cases, LedgerRuns::pack)) {
        evidence.spreads = spreads(packs(fidelity), records);
        evidence.pack_readings = matrix(pack_readings(fidelity), records);
    }
    if (rest_on(cases, LedgerRuns::sandwich))
        evidence.sandwich_readings = matrix(sandwich_readings(fidelity), records);
    return evidence;
}

}  // namespace

std::vector<const Entry*> claiming_cases() {
    std::vector<const Entry*> cases;
    for (const Entry& entry : catalogue())
        if (entry.claims) cases.push_back(&entry);
    std::stable_partition(cases.begin(), cases.end(),
                          [](const Entry* entry) { return entry->figure.starts_with("Table"); });
    return cases;
}

std::vector<Run> runs(Fidelity fidelity, const Cases& cases) {
    std::vector<Run> all;
    std::set<std::pair<std::string, std::string>> seen;
    const auto add = [&](const std::vector<Run>& more) {
        for (const Run& run : more)
            if (seen.emplace(run.experiment, run.setting.text()).second) all.push_back(run);
    };
    for (const Series& series : series_of(fidelity, cases)) add(runs(series));
    if (rest_on(cases, LedgerRuns::pack)) {
        add(runs(packs(fidelity)));
        add(runs(pack_readings(fidelity)));
    }
    if (rest_on(cases, LedgerRuns::sandwich)) add(runs(sandwich_readings(fidelity)));
    return all;
}

reports::Ledger judged(Fidelity fidelity, const Cases& cases, const Records& records,
                       decltype(Evidence::finding) finding) {
    Evidence evidence = evidence_of(fidelity, cases, records);
    evidence.finding = std::move(finding);
    reports::Ledger ledger;
    for (const Entry* const entry : cases)
        std::ranges::move(entry->claims(evidence), std::back_inserter(ledger.rows));
    for (const auto& matrix : {evidence.sandwich_readings, evidence.pack_readings})
        if (!matrix.runs.empty()) ledger.readings.push_back(matrix);
    ledger.refinements = std::move(evidence.refinements);
    ledger.spreads = std::move(evidence.spreads);
    return ledger;
}

}  // namespace crawford::ledger
