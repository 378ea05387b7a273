#include <fmt/format.h>

#include <cmath>

#include "reports/default_estimate.hpp"
#include "reports/judgement.hpp"
#include "reports/order_judgement.hpp"

namespace crawford::reports {
namespace {

std::string number(double value, const char* form) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(form), value) : "-";
}

/// A row a grid; the order that led to it at its end.
std::string grids(const OrderTable& table, const JudgedColumn& column) {
    const GateResult& r = column.result;
    auto text = fmt::format("  {:>4}  {:>12}", "grid", table.size_name);
    if (table.counts_cells()) text += fmt::format("  {:>12}", "h");
    text += fmt::format("  {:>16}  {:>7}\n", column.is_error ? "error" : "value", "order");
    const std::size_t blank = r.h.size() - r.pairwise.size();
    for (std::size_t i = 0; i < r.h.size(); ++i) {
        text += fmt::format("  {:>4}  {:>12g}", i + 1, table.sizes[i]);
        if (table.counts_cells()) text += fmt::format("  {:>12.6g}", r.h[i]);
        text += fmt::format("  {:>16.9g}  {:>7}\n", column.values()[i],
                            i < blank ? "" : number(r.pairwise[i - blank], "{:.3f}"));
    }
    return text;
}

std::string verdict(const GateResult& r) {
    auto text = fmt::format("  fit {}, {}", number(r.fit, "{:.3f}"), r.verdict);
    if (!r.gated) return text + (r.failure.empty() ? "" : ": " + r.failure) + '\n';
    text += fmt::format("; expected {:g} within {:g}: {}", r.expected, r.below, word(mark(r)));
    return text + (r.passed ? "" : ": " + r.failure) + '\n';
}

std::string estimates(const std::vector<Estimate>& all) {
    auto text = fmt::format("  {:<18} {:>7} {:>16} {:>12} {:>9} {:>7}\n", "estimate", "order",
                            "at h -> 0", "uncertainty", "relative", "safety");
    for (const Estimate& e : all) {
        text += fmt::format(
            "{:<2}{:<18} {:>7} {:>16} {:>12} {:>9} {:>7}", e.name == default_estimate ? "*" : "",
            e.name, number(e.order, "{:.3f}"), number(e.extrapolated, "{:.9g}"),
            number(e.uncertainty, "{:.3e}"), number(100.0 * e.relative_uncertainty, "{:.2g} %"),
            number(e.safety, "{:.3g}"));
        text += e.note.empty() ? "\n" : fmt::format("  {}\n", e.note);
    }
    return text + fmt::format("* {}\n", default_estimate_because);
}

}  // namespace

std::string text(const OrderTable& table, const JudgedColumn& column) {
    return fmt::format("{}: {}\n{}{}{}", table.name, column.result.quantity, grids(table, column),
                       verdict(column.result), column.is_error ? "" : estimates(column.estimates));
}

}  // namespace crawford::reports
