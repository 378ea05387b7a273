/// The ledger's numbers with other packs of the paper's discs.
#pragma once

#include "cases/paper/ledger/experiment.hpp"
#include "cases/paper/ledger/subject.hpp"
#include "reports/ledger.hpp"

namespace crawford::ledger {

/// What spreads and refinements are of.
inline constexpr auto of_pack = "pack", of_pack_2Q = "pack, 2Q", of_rigid_pack = "pack, rigid";

/// What the spread of a measure is called.
std::string spread_name(const std::string& of, const Measure& measure);

/// An experiment: one run a seed, rigid, with mechanics, and under twice the flux.
struct Packs {
    Resolution resolution;
    std::vector<unsigned long> seeds;
};
Packs packs(Fidelity fidelity);

std::vector<Run> runs(const Packs& packs);

/// Mean and spread of the pack's numbers, named as in the rows: rigid, with mechanics ("pack"), and
/// under twice the flux.
/// \throws NumericalFailure if a run failed.
std::vector<reports::Spread> spreads(const Packs& packs, const Records& records);

}  // namespace crawford::ledger
