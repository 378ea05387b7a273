/// The rows of the ledger, by where their numbers come from.
#pragma once

#include <functional>
#include <vector>

#include "cases/registry.hpp"
#include "reports/claim.hpp"

namespace crawford::ledger {

/// The number that a drawn case has found under a name.
/// \throws std::logic_error if the case has not found it.
using Findings = std::function<double(const std::string& entry, const std::string& what)>;

/// Closed forms and figures without a burn: Table 1, sections 2.1 and 4, Fig. 6, Fig. 9, Fig. 12.
std::vector<reports::LedgerRow> rows_of_findings(const Findings& finding);

/// The sandwich of section 5.1. `refinements` and `matrix` are those of the ledger.
std::vector<reports::LedgerRow> rows_of_sandwich(
    const Request& request, const std::vector<reports::Refinement>& refinements,
    const reports::ReadingMatrix& matrix);

/// The pack of section 5.2.
std::vector<reports::LedgerRow> rows_of_pack(const Request& request, const reports::Ledger& found,
                                             const reports::ReadingMatrix& matrix);

/// What a quantity of a matrix becomes under each other reading, those that change least first.
std::vector<reports::OtherReading> others(const reports::ReadingMatrix& matrix,
                                          const std::string& quantity);

}  // namespace crawford::ledger
