/// Gate results as text for people.
#pragma once

#include <string>
#include <vector>

#include "reports/gate.hpp"

namespace crawford::reports {

/// Plain text, at most 100 columns: each gate with its errors, pairwise orders, fit, verdict,
/// reason and pass or FAIL.
std::string table(const std::vector<GateResult>& results);

/// How many gates have come out how.
struct Count {
    std::size_t passed = 0, failed = 0, not_gated = 0;

    std::size_t all() const { return passed + failed + not_gated; }
};
Count count(const std::vector<GateResult>& results);

/// How a gate, or all gates of a study, came out: on the terminal and on pages alike.
enum class Mark { pass, fail, not_gated };
Mark mark(const GateResult& result);
Mark mark(const Count& count);

/// "pass", "FAIL", "not gated".
const char* word(Mark mark);

/// "60 of 60 gates pass", or "12 pass, 1 fail, 30 not gated: too few grids".
std::string text(const Count& count);

/// True if there is at least one result and all have passed.
bool all_passed(const std::vector<GateResult>& results);

}  // namespace crawford::reports
