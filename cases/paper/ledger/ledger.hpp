/// The ledger of the paper's claims: what must be run for it, and what is made of the records.
#pragma once

#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/ledger/experiment.hpp"

namespace crawford::ledger {

/// Entries whose claims it collects, in the order of the paper: Table 1, then figures.
std::vector<const Entry*> claiming_cases();

/// Runs of readings, refinements and packs that the claims of these cases rest on, each once.
std::vector<Run> runs(Fidelity fidelity, const std::vector<const Entry*>& cases);

/// The rows of these cases, and what they rest on, from records alone. `finding` is that of
/// Evidence, of these cases. The manifest is left empty.
/// \throws NumericalFailure if a run failed that a refinement or a spread needs.
reports::Ledger judged(Fidelity fidelity, const std::vector<const Entry*>& cases,
                       const Records& records, decltype(Evidence::finding) finding);

}  // namespace crawford::ledger
