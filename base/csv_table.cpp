#include "base/csv_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include "base/errors.hpp"

namespace crawford {

namespace {

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// The mark that some programs put before UTF-8 is no part of the first heading.
std::string without_byte_order_mark(const std::string& row) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return row.starts_with(mark) ? row.substr(mark.size()) : row;
}

void refuse_separator(char c, const std::string& place) {
    for (const auto& [separator, name] : {std::pair{';', "semicolons"}, {'\t', "tabs"}})
        if (c == separator)
            throw InputError(fmt::format(
                "{} has {}; cells are separated by commas, decimals have a point", place, name));
}

/// The cells of a row. Within quotes a comma is a letter, and two quotes are one.
std::vector<std::string> cells(const std::string& row, const std::string& place) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const char c = row[k];
        if (c == '"' && is_quoted && k + 1 < row.size() && row[k + 1] == '"') {
            cells.back() += row[++k];
        } else if (c == '"') {
            is_quoted = !is_quoted;
        } else if (c == ',' && !is_quoted) {
            cells.emplace_back();
        } else {
            if (!is_quoted) refuse_separator(c, place);
            cells.back() += c;
        }
    }
    if (is_quoted)
        throw InputError(fmt::format("{} has a quote that is not closed on its line", place));
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

void require_whole(const std::vector<std::string>& cells, const CsvTable& table, int line) {
    if (cells.size() != table.header.size())
        throw InputError(fmt::format("{} has {} values; expected {}", table.place(line),
                                     cells.size(), table.header.size()));
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (cells[k].empty())
            throw InputError(fmt::format("{} the cell of column \"{}\" is empty", table.place(line),
                                         table.header[k]));
}

std::ifstream opened(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{} cannot be opened; check the name and that it may be read",
                                     file.string()));
    return stream;
}

}  // namespace

std::string CsvTable::place(int line) const {
    return fmt::format("{}:{}:", file.string(), line);
}

CsvTable read_csv(const std::filesystem::path& file) {
    std::ifstream stream = opened(file);
    CsvTable table{.file = file, .header_line = 0, .header = {}, .rows = {}};
    std::string text;
    for (int line = 1; std::getline(stream, text); ++line) {
        const std::string row = trimmed(line == 1 ? without_byte_order_mark(text) : text);
        if (row.empty() || row.front() == '#') continue;
        auto found = cells(row, table.place(line));
        if (table.header.empty()) {
            table.header = std::move(found);
            table.header_line = line;
        } else {
            require_whole(found, table, line);
            table.rows.push_back({line, std::move(found)});
        }
    }
    if (table.header.empty()) throw InputError(fmt::format("{} is empty", file.string()));
    return table;
}

double csv_number(const std::string& cell, const std::string& place) {
    const std::string_view text = std::string_view(cell).substr(cell.starts_with('+') ? 1 : 0);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc::result_out_of_range)
        throw InputError(
            fmt::format("{} \"{}\" is too large or too small for a double", place, cell));
    if (error != std::errc() || end != text.data() + text.size())
        throw InputError(
            fmt::format("{} \"{}\" is no number; the unit stands in the first row", place, cell));
    if (!std::isfinite(number))
        throw InputError(fmt::format("{} \"{}\" is no finite number", place, cell));
    return number;
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += c;
        cell += c == '\n' ? ' ' : c;
    }
    return cell + '"';
}

CsvHeading csv_heading(const std::string& heading) {
    const auto open = heading.find('[');
    if (open == std::string::npos || !heading.ends_with(']')) return {heading, ""};
    return {trimmed(heading.substr(0, open)), heading.substr(open + 1, heading.size() - open - 2)};
}

}  // namespace crawford
