/// What the verdicts of a ledger rest on. Each is empty if there is nothing to show.
#pragma once

#include "reports/ledger.hpp"
#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// A table for each matrix: runs down, quantities across, the paper's values on top, the reading
/// that comes nearest marked.
Html readings(const std::vector<ReadingMatrix>& matrices);

/// A table for each series of sizes: quantities down, sizes across, then what they tend to.
Html refinements(const std::vector<Refinement>& refinements);

/// Every number over the packs, one a seed, then mean and deviation.
Html spreads(const std::vector<Spread>& spreads);

}  // namespace crawford::reports::page
