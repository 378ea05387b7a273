#include "reports/order_judgement.hpp"

#include <cmath>

#include "reports/value_order.hpp"

namespace crawford::reports {
namespace {

Convergence errors(const OrderTable& table, const OrderColumn& column, double size) {
    std::vector<Level> levels;
    for (std::size_t i = 0; i < table.h.size(); ++i)
        levels.push_back({table.grids[i], table.h[i], column.values[i]});
    return Convergence(levels, size);
}

ValueConvergence values(const OrderTable& table, const OrderColumn& column) {
    std::vector<ValueLevel> levels;
    for (std::size_t i = 0; i < table.h.size(); ++i)
        levels.push_back({table.grids[i], table.h[i], column.values[i]});
    return ValueConvergence(levels);
}

/// Without an expectation there is a fit and a verdict, and nothing passes or fails.
void leave_unexpected(GateResult& result) {
    result.gated = result.passed = false;
    result.expected = result.below = result.above = not_applicable;
    if (result.verdict != "none") result.failure.clear();
}

/// The grids that the gate runs over.
std::vector<Estimate> estimates_of(const OrderTable& table, const OrderColumn& column,
                                   const GateResult& result, double formal_order) {
    std::vector<double> h, u;
    for (std::size_t i = 0; i < table.h.size(); ++i) {
        if (table.grids[i] < result.coarsest || table.grids[i] > result.finest) continue;
        // A defect of its own, which the judgement names.
        if (!std::isfinite(column.values[i]) || (!h.empty() && !(table.h[i] < h.back()))) return {};
        h.push_back(table.h[i]);
        u.push_back(column.values[i]);
    }
    return estimates({h, u}, formal_order);
}

}  // namespace

JudgedColumn judge(const OrderTable& table, const OrderColumn& column,
                   const OrderQuestion& question) {
    const Expectation expected = question.expected.value_or(expect(usual_order));
    const Gate gate{column.name, Norm::magnitude, expected,
                    question.expected ? question.reason : "nothing is expected"};
    JudgedColumn judged{column.is_error, {}, {}};
    judged.result = column.is_error ? judge(gate, errors(table, column, question.size), table.grids)
                                    : judge(gate, values(table, column));
    judged.result.study = table.name;
    judged.result.norm = column.is_error ? "error" : "value";
    if (!question.expected) leave_unexpected(judged.result);
    judged.estimates = estimates_of(table, column, judged.result, expected.order);
    return judged;
}

}  // namespace crawford::reports
