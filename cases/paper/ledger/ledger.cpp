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

Evidence evidence_of(Fidelity fidelity, const Records& records) {
    Evidence evidence;
    for (const Series& series : all_series(fidelity))
        std::ranges::move(refinements(series, records), std::back_inserter(evidence.refinements));
    evidence.spreads = spreads(packs(fidelity), records);
    evidence.pack_readings = matrix(pack_readings(fidelity), records);
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

std::vector<Run> runs(Fidelity fidelity) {
    std::vector<Run> all;
    std::set<std::pair<std::string, std::string>> seen;
    const auto add = [&](const std::vector<Run>& more) {
        for (const Run& run : more)
            if (seen.emplace(run.experiment, run.setting.text()).second) all.push_back(run);
    };
    for (const Series& series : all_series(fidelity)) add(runs(series));
    add(runs(packs(fidelity)));
    add(runs(pack_readings(fidelity)));
    add(runs(sandwich_readings(fidelity)));
    return all;
}

reports::Ledger judged(Fidelity fidelity, const Records& records,
                       decltype(Evidence::finding) finding) {
    Evidence evidence = evidence_of(fidelity, records);
    evidence.finding = std::move(finding);
    reports::Ledger ledger;
    for (const Entry* const entry : claiming_cases())
        std::ranges::move(entry->claims(evidence), std::back_inserter(ledger.rows));
    ledger.readings = {evidence.sandwich_readings, evidence.pack_readings};
    ledger.refinements = std::move(evidence.refinements);
    ledger.spreads = std::move(evidence.spreads);
    return ledger;
}

}  // namespace crawford::ledger
