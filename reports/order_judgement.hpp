/// What a table of errors or values shows, column by column.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/estimate.hpp"
#include "reports/gate.hpp"
#include "reports/order_table.hpp"

namespace crawford::reports {

/// A column with its judgement.
struct JudgedColumn {
    bool is_error;
    GateResult result;  ///< not gated where nothing is expected
    std::vector<Estimate> estimates;

    const std::vector<double>& values() const { return is_error ? result.errors : result.values; }
};

/// What is asked of a table.
struct OrderQuestion {
    std::optional<Expectation> expected;  ///< nothing is gated without
    std::string reason;                   ///< of what is expected
    double size = 1.0;                    ///< of the truth of errors, that round-off is told by
};

/// The order that estimates take for the formal one where none is expected: that of most schemes in
/// use.
inline constexpr double usual_order = 2.0;

JudgedColumn judge(const OrderTable& table, const OrderColumn& column,
                   const OrderQuestion& question);

/// For a terminal: grids, values, orders, fit, verdict, the estimates of values.
std::string text(const OrderTable& table, const JudgedColumn& column);

}  // namespace crawford::reports
