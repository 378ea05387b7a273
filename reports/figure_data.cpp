#include "reports/figure_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace crawford::reports {
namespace {

void check(const std::vector<Column>& columns) {
    if (columns.empty() || columns[0].values.empty())
        throw std::invalid_argument("csv: nothing to write");
    for (const auto& column : columns) {
        if (column.values.size() != columns[0].values.size())
            throw std::invalid_argument(fmt::format("csv: column '{}' has {} values, '{}' has {}",
                                                    column.name, column.values.size(),
                                                    columns[0].name, columns[0].values.size()));
        if ((column.name + column.unit).find_first_of(",\"\r\n") != std::string::npos)
            throw std::invalid_argument(
                fmt::format("csv: header '{} [{}]'", column.name, column.unit));
    }
}

std::string header(const std::vector<Column>& columns) {
    std::string line;
    for (const auto& column : columns)
        line += fmt::format("{}{} [{}]", line.empty() ? "" : ",", column.name, column.unit);
    return line + '\n';
}

void append_row(std::string& text, const std::vector<Column>& columns, std::size_t row) {
    for (std::size_t i = 0; i < columns.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{}", i == 0 ? "" : ",", columns[i].values[row]);
    text += '\n';
}

/// Values at corners: those of the cell whose lowest corner it is.
Column at_corners(const Column& cells, std::size_t columns, std::size_t rows) {
    Column corners{cells.name, cells.unit, {}};
    for (std::size_t j = 0; j <= rows; ++j)
        for (std::size_t i = 0; i <= columns; ++i)
            corners.values.push_back(
                cells.values[std::min(j, rows - 1) * columns + std::min(i, columns - 1)]);
    return corners;
}

}  // namespace

std::string csv(const std::vector<Column>& columns) {
    check(columns);
    std::string text = header(columns);
    for (std::size_t row = 0; row < columns[0].values.size(); ++row) append_row(text, columns, row);
    return text;
}

bool QuadMap::at_cells() const {
    return std::ranges::all_of(fields,
                               [&](const Column& f) { return f.values.size() == columns * rows; });
}

std::string csv(const QuadMap& map) {
    if (map.columns == 0 || map.rows == 0 ||
        map.x.values.size() != (map.columns + 1) * (map.rows + 1))
        throw std::invalid_argument(fmt::format("csv: map of {} x {} cells with {} corners",
                                                map.columns, map.rows, map.x.values.size()));
    std::vector<Column> all{map.x, map.y};
    for (const auto& field : map.fields)
        all.push_back(map.at_cells() ? at_corners(field, map.columns, map.rows) : field);
    check(all);
    std::string text = header(all);
    for (std::size_t row = 0; row < map.x.values.size(); ++row) {
        append_row(text, all, row);
        if ((row + 1) % (map.columns + 1) == 0) text += '\n';
    }
    return text;
}

}  // namespace crawford::reports
