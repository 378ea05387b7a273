/// Tables of what became of the faults, in Markdown.
#pragma once

#include <string>
#include <vector>

#include "hunt.hpp"

namespace crawford::mutants {

/// One row a fault: what it breaks, who saw it, in how many seconds; then the survivors, those
/// that another judge saw than the row says, and the rows that are worthless.
std::string table_of_faults(const std::vector<Verdict>& verdicts, bool every_gate);

/// One row a judge: how many faults it sees, and those that nobody else sees, its reason to be
/// there. Meaningful only where every judge has looked at every fault.
std::string table_of_judges(const std::vector<Verdict>& verdicts);

}  // namespace crawford::mutants
