#include "cases/paper/ledger/ledger.hpp"

#include "cases/paper/ledger/readings.hpp"
#include "cases/paper/ledger/refinements.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"

namespace crawford::ledger {

namespace {

using namespace units;

/// Readings are compared on coarse grids with long steps: what they change is far more than what
/// those do, and there are many.
Resolution of_pack_readings(Fidelity fidelity) {
    if (fidelity == Fidelity::draft) return {40, 32, 200 * us, 0.04};
    return {60, 48, 100 * us, 0.135};
}

Resolution of_sandwich_readings(Fidelity fidelity) {
    if (fidelity == Fidelity::draft) return {16, 24, 160 * us, 0.04};
    return {32, 48, 80 * us, 0.1};
}

}  // namespace

std::vector<std::string> cited_cases() {
    return {"table1", "fig03", "fig04", "fig06", "fig09", "fig12"};
}

std::vector<Scene> scenes(Fidelity fidelity) {
    std::vector<Scene> all = {burning_sandwich(fidelity, true), burning_sandwich(fidelity, false),
                              burning_pack(fidelity), burning_pack(fidelity, {.mechanics = false}),
                              burning_pack(fidelity, {.flux = 2.0})};
    const auto add = [&](const std::vector<Scene>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const Series& series : all_series(fidelity)) add(scenes_of(series));
    add(scenes_of(packs(fidelity)));
    add(scenes_of(Subject("pack.toml"), of_pack_readings(fidelity), pack_readings()));
    add(scenes_of(Subject("sandwich.toml"), of_sandwich_readings(fidelity), sandwich_readings()));
    return all;
}

reports::Ledger settle(const Request& request, const Findings& finding) {
    reports::Ledger found;
    for (const Series& series : all_series(request.fidelity))
        for (const auto& refinement : refinements(series, request))
            found.refinements.push_back(refinement);
    found.spreads = spreads(packs(request.fidelity), request);
    found.readings = {sandwich_matrix(of_sandwich_readings(request.fidelity), request),
                      pack_matrix(of_pack_readings(request.fidelity), request)};
    found.rows = rows_of_findings(finding);
    const auto add = [&](const std::vector<reports::LedgerRow>& more) {
        found.rows.insert(found.rows.end(), more.begin(), more.end());
    };
    add(rows_of_sandwich(request, found.refinements, found.readings.front()));
    add(rows_of_pack(request, found, found.readings.back()));
    return found;
}

}  // namespace crawford::ledger
