#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "program/commands.hpp"
#include "program/outside_options.hpp"
#include "reports/junit.hpp"
#include "reports/order_json.hpp"
#include "reports/order_judgement.hpp"
#include "reports/order_plot.hpp"
#include "reports/verification.hpp"

namespace crawford {

namespace {

using Columns = std::vector<reports::JudgedColumn>;

void check(const OrderOptions& options) {
    const auto require_positive = [](const char* option, double value) {
        if (!(value > 0.0)) throw InputError(fmt::format("{} {} must be above 0", option, value));
    };
    if (options.dimension < 1 || options.dimension > 3)
        throw InputError(fmt::format("--dimension {} must be 1, 2 or 3", options.dimension));
    if (options.expect) require_positive("--expect", *options.expect);
    require_positive("--within", options.within);
    if (options.scatter) require_positive("--scatter", *options.scatter);
    require_positive("--size", options.size);
}

std::vector<reports::OrderColumn> wanted(const reports::OrderTable& table,
                                         const std::vector<std::string>& names) {
    if (names.empty()) return table.columns;
    std::vector<std::string> known;
    for (const auto& column : table.columns) known.push_back(column.name);
    std::vector<reports::OrderColumn> columns;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(table.columns, name, &reports::OrderColumn::name);
        if (found == table.columns.end())
            throw InputError(fmt::format("--quantity {}: {} has no such column{}", name, table.name,
                                         suggestion(name, known)));
        columns.push_back(*found);
    }
    return columns;
}

reports::OrderQuestion question_of(const OrderOptions& options, const reports::OrderTable& table) {
    reports::OrderQuestion question{.expected = {}, .reason = "", .size = options.size};
    const auto range = [&](reports::Expectation expected) {
        if (options.from) expected = expected.from(table.grid_of(*options.from, "--from"));
        if (options.to) expected = expected.to(table.grid_of(*options.to, "--to"));
        if (options.scatter) expected = expected.scattering(*options.scatter);
        return expected;
    };
    if (options.expect) {
        question.expected = range(reports::expect(*options.expect).within(options.within));
        question.reason = fmt::format("it was asked for: --expect {:g} --within {:g}",
                                      *options.expect, options.within);
    }
    return question;
}

void write_junit_of(const std::filesystem::path& file, const reports::OrderTable& table,
                    const Columns& columns) {
    reports::Verification found;
    found.studies.push_back({.name = table.name});
    for (const auto& column : columns) found.gates.push_back(column.result);
    reports::write_junit(file, found);
}

void tell(const OrderOptions& options, const reports::OrderTable& table, const Columns& columns) {
    if (options.json != "-")
        for (const auto& column : columns) std::cout << reports::text(table, column) << '\n';
    if (!options.json) return;
    const std::string json = reports::order_json(columns).dump(
                                 2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                             '\n';
    if (options.json == "-")
        std::cout << json;
    else
        write_file(*options.json, json);
}

}  // namespace

int order(const OrderOptions& options) {
    check(options);
    const auto table = reports::order_table(read_csv(options.table), options.dimension);
    const auto question = question_of(options, table);
    Columns columns;
    for (const auto& column : wanted(table, options.quantities))
        columns.push_back(reports::judge(table, column, question));
    if (options.plot) reports::draw_orders(*options.plot, table, columns);
    if (options.junit) write_junit_of(*options.junit, table, columns);
    tell(options, table, columns);
    const bool fell_short =
        std::ranges::any_of(columns, [](const auto& column) { return column.result.fell_short(); });
    return fell_short ? exit_code::gate_fell_short : exit_code::done;
}

}  // namespace crawford
