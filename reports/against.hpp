/// The yardstick: what one run of the studies found, held against an earlier one. An error that
/// triples at the same order passes every gate of order; here it is seen.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reports/gate.hpp"

namespace crawford::reports {

/// How strict a comparison is.
struct Yardstick {
    double grown = 1.05;  ///< >= 1; an error that changed by a larger factor is listed
    bool exact = false;   ///< every number that a judgement rests on must be the same, bit for bit
};

/// Which of the earlier gates a run could find again.
struct Scope {
    bool every_study = true;           ///< no study was chosen
    std::vector<std::string> studies;  ///< else those that were run
    bool own_grids = true;             ///< no grids were chosen: each study ran on all its own
};

/// What has become of a gate.
enum class Change {
    gone,   ///< it was there before, and its study has run
    added,  ///< it was not there before
    lost,   ///< it passed before and does not now
    grown,  ///< its finest error grew by more than the factor, or is no number any more
    shrunk,
    from_roundoff,  ///< its finest error was round-off and no yardstick, and has grown
    other           ///< its verdict changed or, where exact, any of its numbers
};

/// "gone", "new", "lost", "grown", "shrunk", "round-off", "other".
std::string_view name(Change change);

struct ChangedGate {
    Change change;
    std::string gate;    ///< "study/quantity, norm"
    std::string detail;  ///< numbers before and now; empty for gone and new
};

struct Comparison {
    std::vector<ChangedGate> changed;
    std::size_t compared = 0;     ///< gates that both runs hold and have judged
    std::size_t left_out = 0;     ///< earlier gates that this run was not asked for
    double largest_growth = 0.0;  ///< of the finest errors, a factor; 0 if no error was compared
    Yardstick yardstick;

    std::size_t count(Change change) const;
    /// Whether an error has grown or, where exact, anything is gone, new or other.
    bool fell_short() const;
};

/// Gates are matched by study, kind, quantity and norm; if several share these, in their order.
/// Seconds and wording do not count. NaN equals NaN. Errors are compared on the finest grid that
/// both runs have. A gate without verdict, for want of grids that were not chosen, is left out,
/// unless the comparison is exact and both runs are without.
Comparison compare(const std::vector<GateResult>& before, const std::vector<GateResult>& now,
                   const Scope& scope, const Yardstick& yardstick);

/// Lines of at most 80 columns: each change, then how many gates were compared and what came out.
std::string text(const Comparison& comparison);

}  // namespace crawford::reports
