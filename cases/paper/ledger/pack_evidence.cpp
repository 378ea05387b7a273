#include "cases/paper/ledger/pack_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace crawford::ledger {

namespace {

const reports::Spread& spread_of(const Evidence& evidence, const std::string& of,
                                 const Measure& measure) {
    const auto name = spread_name(of, measure);
    const auto spread = std::ranges::find(evidence.spreads, name, &reports::Spread::quantity);
    if (spread == evidence.spreads.end())
        throw std::logic_error("the ledger has no spread of " + name);
    return *spread;
}

}  // namespace

reports::Uncertainty uncertainty(const Evidence& evidence, const std::string& of,
                                 const Measure& measure) {
    const std::string refined = of == of_pack_2Q ? of_pack : of;
    return {.grid = index(evidence, refined, measure, "x and y"),
            .step = index(evidence, refined, measure, "dt"),
            .packs = 2.0 * spread_of(evidence, of, measure).deviation};
}

reports::Uncertainty uncertainty_of_peak(const Evidence& evidence, const std::string& of) {
    return {.packs = percent(2.0 * spread_of(evidence, of, mean_strain).deviation)};
}

reports::Uncertainty uncertainty_of_change(const Evidence& evidence, const Measure& measure,
                                           double (*change)(double coupled, double rigid)) {
    const auto& coupled = spread_of(evidence, of_pack, measure).values;
    const auto& rigid = spread_of(evidence, of_rigid_pack, measure).values;
    std::vector<double> changes;
    for (size_t k = 0; k < coupled.size(); ++k) changes.push_back(change(coupled[k], rigid[k]));
    return {.packs = 2.0 * deviation(changes)};
}

reports::LedgerRow judged(const reports::Claim& claim, const MeanPeak& peak,
                          const reports::Uncertainty& uncertainty) {
    const double about_peak = percent(peak.about_peak);
    return reports::judged(
        claim, {percent(peak.strain), uncertainty, pack_as_read + "; this grid",
                before({"the mean over 5 um about the peak", about_peak}, peak.others),
                fmt::format("A peak in a corner has no limit; over 5 um about it {:.1f} %. {}",
                            about_peak, peak.grids),
                "{:.1f}"});
}

}  // namespace crawford::ledger
