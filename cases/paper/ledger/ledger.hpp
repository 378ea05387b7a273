/// The ledger of the paper's claims: what must be burnt for it, and what is made of the burns.
#pragma once

#include "cases/paper/ledger/rows.hpp"

namespace crawford::ledger {

/// Cases whose findings it cites; their burns are among scenes().
std::vector<std::string> cited_cases();

/// All burns: of readings, refinements and packs, and those of the figures.
std::vector<Scene> scenes(Fidelity fidelity);

/// The ledger, from burns that are there (missing ones are made, one by one). Its manifest is left
/// empty.
reports::Ledger settle(const Request& request, const Findings& finding);

}  // namespace crawford::ledger
