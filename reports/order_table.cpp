#include "reports/order_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "base/errors.hpp"

namespace crawford::reports {
namespace {

struct Size {
    double size;
    const CsvRow* row;
};

void check_header(const CsvTable& csv) {
    const std::string place = csv.place(csv.header_line);
    const std::string& first = csv.header.front();
    if (csv_heading(first).name != "h" && first != "cells")
        throw InputError(fmt::format(
            "{} the first column is \"{}\"; it must be h, h [unit] or cells", place, first));
    if (csv.header.size() < 2)
        throw InputError(fmt::format(
            "{} there is only \"{}\"; a table has a column for each error or value, too", place,
            first));
    std::set<std::string> seen;
    for (const std::string& heading : csv.header) {
        if (heading.empty()) throw InputError(fmt::format("{} a column has no heading", place));
        if (!seen.insert(heading).second)
            throw InputError(fmt::format("{} has the column \"{}\" twice", place, heading));
    }
}

/// Coarsest first.
std::vector<Size> sorted_sizes(const CsvTable& csv, bool counts_cells) {
    std::vector<Size> sizes;
    for (const CsvRow& row : csv.rows) {
        const double size = csv_number(row.cells.front(), csv.place(row.line));
        if (size <= 0.0)
            throw InputError(fmt::format("{} {} = {} must be above 0", csv.place(row.line),
                                         csv.header.front(), size));
        for (const Size& other : sizes)
            if (other.size == size)
                throw InputError(fmt::format("{} {} = {} stands in line {}, too: each grid once",
                                             csv.place(row.line), csv.header.front(), size,
                                             other.row->line));
        sizes.push_back({size, &row});
    }
    std::ranges::sort(sizes, [&](const Size& a, const Size& b) {
        return counts_cells ? a.size < b.size : a.size > b.size;
    });
    return sizes;
}

bool are_numbers_of_cells(const std::vector<double>& sizes) {
    return std::ranges::all_of(
        sizes, [](double n) { return n == std::round(n) && n <= std::numeric_limits<int>::max(); });
}

}  // namespace

int OrderTable::grid_of(double size, const std::string& option) const {
    const auto found = std::ranges::find(sizes, size);
    if (found == sizes.end())
        throw InputError(fmt::format("{} {}: no row has {} = {}", option, size, size_name, size));
    return grids[static_cast<std::size_t>(found - sizes.begin())];
}

OrderTable order_table(const CsvTable& csv, int dimension) {
    check_header(csv);
    OrderTable table{.name = csv.file.stem().string(),
                     .size_name = csv.header.front(),
                     .sizes = {},
                     .h = {},
                     .grids = {},
                     .columns = {}};
    for (std::size_t k = 1; k < csv.header.size(); ++k)
        table.columns.push_back({csv.header[k], csv.header[k].starts_with("error"), {}});
    for (const auto& [size, row] : sorted_sizes(csv, table.counts_cells())) {
        table.sizes.push_back(size);
        table.h.push_back(table.counts_cells() ? std::pow(size, -1.0 / dimension) : size);
        for (std::size_t k = 1; k < row->cells.size(); ++k)
            table.columns[k - 1].values.push_back(csv_number(row->cells[k], csv.place(row->line)));
    }
    if (table.h.size() < 2)
        throw InputError(fmt::format("{} has {} {}; an order needs three grids, a rate two",
                                     csv.file.string(), table.h.size(),
                                     table.h.size() == 1 ? "grid" : "grids"));
    table.grids.resize(table.h.size());
    if (table.counts_cells() && are_numbers_of_cells(table.sizes))
        std::ranges::transform(table.sizes, table.grids.begin(),
                               [](double n) { return static_cast<int>(n); });
    else
        std::iota(table.grids.begin(), table.grids.end(), 1);
    return table;
}

}  // namespace crawford::reports
