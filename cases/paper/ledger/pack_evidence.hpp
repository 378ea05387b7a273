/// How sure a number of the burning pack is, from grids, steps and other packs.
#pragma once

#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/ledger/packs.hpp"

namespace crawford::ledger {

inline const std::string pack_as_read = "3 alpha K, c_p; mean of the whole run, ignition and all";
inline constexpr auto since_20_ms = "mean from 20 ms on";

/// `of` is of_pack, of_rigid_pack or of_pack_2Q; what doubles the flux was refined without. Packs
/// count with two standard deviations: the paper's own pack is not published.
/// \throws std::logic_error if there is no spread of it.
reports::Uncertainty uncertainty(const Evidence& evidence, const std::string& of,
                                 const Measure& measure);

/// A peak does not converge: only other packs are in its interval [%].
reports::Uncertainty uncertainty_of_peak(const Evidence& evidence, const std::string& of);

/// Of what mechanics changes, pack by pack: what two runs of one pack share cancels.
reports::Uncertainty uncertainty_of_change(const Evidence& evidence, const Measure& measure,
                                           double (*change)(double coupled, double rigid));

/// Mean of the largest strain [%] by its claim. `strain` and `about_peak` are as found, the latter
/// over 5 um; `grids` says what refinement does to it.
struct MeanPeak {
    double strain, about_peak;
    std::string grids = {};
    std::vector<reports::OtherReading> others = {};  ///< [%]
};
reports::LedgerRow judged(const reports::Claim& claim, const MeanPeak& peak,
                          const reports::Uncertainty& uncertainty);

}  // namespace crawford::ledger
