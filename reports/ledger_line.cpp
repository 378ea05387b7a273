#include "reports/ledger_line.hpp"

#include <fmt/format.h>

namespace crawford::reports {

namespace {

constexpr auto columns = "{:<9} {:<58} {:<30} {:<28} {}";

std::string with_unit(const std::string& value, const std::string& unit) {
    return unit.empty() || unit == "-" ? value : value + ' ' + unit;
}

std::string ours(const LedgerRow& row) {
    if (!row.value) return row.ours;
    const auto interval = row.uncertainty.total();
    if (!interval) return with_unit(row.ours, row.unit) + ", not studied";
    if (*interval == 0.0) return with_unit(row.ours, row.unit);
    return with_unit(fmt::format("{} \u00b1 {:.2g}", row.ours, *interval), row.unit);
}

}  // namespace

std::string line_of(const LedgerRow& row) {
    return fmt::format(columns, row.where, row.claim,
                       with_unit(row.paper, row.paper_value ? row.unit : ""), ours(row),
                       name(row.standing));
}

std::string heading_of_lines() {
    return fmt::format(columns, "where", "claim", "paper", "ours", "verdict");
}

}  // namespace crawford::reports
