/// The ledger of the paper's claims: what must be run for it, and what is made of the records.
#pragma once

#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/ledger/experiment.hpp"

namespace crawford::ledger {

/// Entries whose claims it collects, in the order of the paper: Table 1, then figures.
std::vector<const Entry*> claiming_cases();

/// All runs of readings, refinements and packs, each once.
std::vector<Run> runs(Fidelity fidelity);

/// From records alone. `finding` is that of Evidence, of the cases above. The manifest is left
/// empty.
/// \throws NumericalFailure if a run failed that a refinement or a spread needs.
reports::Ledger judged(Fidelity fidelity, const Records& records,
                       decltype(Evidence::finding) finding);

}  // namespace crawford::ledger
