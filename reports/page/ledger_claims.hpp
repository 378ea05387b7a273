/// The claims of the ledger's page, one by one.
#pragma once

#include "reports/ledger.hpp"
#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// Where each row stands in the page of the ledger: made of what it claims and where, so that a
/// link keeps its meaning when rows are added.
std::vector<std::string> anchors_of(const std::vector<LedgerRow>& rows);

/// The verdict as a coloured word.
Html mark(Standing standing);

/// Our number with its unit and its uncertainty, if it was studied.
std::string ours(const LedgerRow& row);

/// Every claim: where, the paper's value, ours, the reading, the verdict and why. `pages` are the
/// cases that have a page, <case>.html.
Html table_of_claims(const std::vector<LedgerRow>& rows, const std::vector<std::string>& pages);

}  // namespace crawford::reports::page
