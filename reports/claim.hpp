/// From a claim of the paper and a number of ours to a row of the ledger with its verdict.
#pragma once

#include <string>
#include <vector>

#include "reports/ledger.hpp"

namespace crawford::reports {

/// What the paper states.
struct Claim {
    std::string claim, where;
    std::string entry;  ///< the case that shows it
    std::string unit;
    std::string printed;
    double value;
    /// What printing leaves open: half a unit of the last digit, and a tenth of the value where the
    /// paper says "about", "roughly" or "approximately".
    double open;
};

/// A number under another reading.
struct OtherReading {
    std::string reading;
    double value;
};

/// What we found.
struct Found {
    double value;
    Uncertainty uncertainty;
    std::string reading;                    ///< under which
    std::vector<OtherReading> others = {};  ///< nearest to our reading first
    std::string because = {};               ///< why it differs, if it does; else what else to know
    std::string format = "{:.4g}";          ///< of the value
};

/// Reproduced if the two numbers lie no further apart than our uncertainty and what printing leaves
/// open together; under another reading, if that holds for one of the others.
/// \throws std::invalid_argument if ours is no number: a ledger has no empty row.
LedgerRow judged(const Claim& claim, const Found& found);

/// A claim in words that we can only hold or not.
struct Statement {
    std::string claim, where, entry;
    std::string printed, ours;
    std::string reading;
    bool holds;
    std::string because;
};
LedgerRow judged(const Statement& statement);

/// Half a unit of the last digit of a printed number: "0.42" is open by 0.005.
double half_digit(const std::string& printed);

}  // namespace crawford::reports
