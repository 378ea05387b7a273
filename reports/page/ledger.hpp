/// The ledger as a page.
#pragma once

#include <string>
#include <vector>

#include "reports/ledger.hpp"

namespace crawford::reports::page {

/// The ledger as a page beside those of the figures: verdicts in numbers, every claim, and what the
/// verdicts rest on. `pages` are the cases that have a page there, <case>.html; index.html is
/// theirs.
std::string ledger_page(const Ledger& ledger, const std::vector<std::string>& pages);

}  // namespace crawford::reports::page
