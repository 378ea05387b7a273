/// The ledger for a terminal.
#pragma once

#include <string>

#include "reports/ledger.hpp"

namespace crawford::reports {

/// One row in one line: where, claim, the paper's value and ours, each with its unit, ours with its
/// interval, and the verdict.
std::string line_of(const LedgerRow& row);

/// What stands above such lines.
std::string heading_of_lines();

}  // namespace crawford::reports
