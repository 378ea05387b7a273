#include "solver/scene/read_discs.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "base/errors.hpp"
#include "solver/scene/units.hpp"

namespace crawford {

namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The cell between quotes that a spreadsheet puts about it, or the cell.
std::string unquoted(const std::string& cell) {
    const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
    return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> cells;
    std::size_t begin = 0;
    for (auto comma = row.find(','); comma != std::string::npos; comma = row.find(',', begin)) {
        cells.push_back(unquoted(trimmed(row.substr(begin, comma - begin))));
        begin = comma + 1;
    }
    cells.push_back(unquoted(trimmed(row.substr(begin))));
    return cells;
}

void refuse_other_separators(const std::string& row, const std::string& place) {
    for (const auto& [separator, name] : {std::pair{';', "semicolons"}, {'\t', "tabs"}})
        if (row.find(separator) != std::string::npos)
            throw InputError(fmt::format(
                "{} has {}; cells are separated by commas, decimals have a point", place, name));
}

/// The mark that some programs put before UTF-8 is no part of the first heading.
std::string without_byte_order_mark(const std::string& row) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return row.starts_with(mark) ? row.substr(mark.size()) : row;
}

struct Column {
    double Disc::*member;
    std::string unit;
};

constexpr std::array<std::pair<std::string_view, double Disc::*>, 3> members{
    {{"x", &Disc::x}, {"y", &Disc::y}, {"radius", &Disc::radius}}};

/// "radius [um]" is the member `radius` in um.
Column column(const std::string& heading, const std::string& place) {
    const auto open = heading.find('[');
    for (const auto& [name, member] : members) {
        if (open == std::string::npos || !heading.ends_with(']')) break;
        if (trimmed(heading.substr(0, open)) != name) continue;
        return {member, heading.substr(open + 1, heading.size() - open - 2)};
    }
    throw InputError(
        fmt::format("{} has the column \"{}\"; a table of discs begins with the row \"x [um],y "
                    "[um],radius [um]\", in any unit of length",
                    place, heading));
}

std::vector<Column> columns(const std::string& header, const std::string& place) {
    std::vector<Column> columns;
    std::vector<double Disc::*> seen;
    for (const std::string& heading : cells(header)) {
        columns.push_back(column(heading, place));
        for (const auto member : seen) {
            if (member == columns.back().member) {
                throw InputError(fmt::format("{} has the column \"{}\" twice", place, heading));
            }
        }
        seen.push_back(columns.back().member);
    }
    if (columns.size() != members.size()) {
        throw InputError(fmt::format("{} has {} columns; expected the three x, y and radius", place,
                                     columns.size()));
    }
    return columns;
}

Disc disc(const std::string& row, const std::vector<Column>& columns, const std::string& place) {
    const std::vector<std::string> numbers = cells(row);
    if (numbers.size() != columns.size()) {
        throw InputError(
            fmt::format("{} has {} values; expected {}", place, numbers.size(), columns.size()));
    }
    Disc disc{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (numbers[i].find_first_not_of("+-.0123456789eE") != std::string::npos)
            throw InputError(fmt::format(
                "{}: \"{}\" is no number; the unit stands in the first row", place, numbers[i]));
        const std::string quantity = numbers[i] + " " + columns[i].unit;
        try {
            disc.*columns[i].member = read_quantity(quantity, "m");
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: \"{}\" {}", place, quantity, error.what()));
        }
    }
    return disc;
}

}  // namespace

std::vector<Disc> read_discs(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) {
        throw InputError(
            fmt::format("{} cannot be opened; check the name and that it may be read, the path "
                        "being relative to the scene file",
                        file.string()));
    }
    std::vector<Column> header;
    std::vector<Disc> discs;
    std::string row;
    for (int line = 1; std::getline(stream, row); ++line) {
        row = trimmed(line == 1 ? without_byte_order_mark(row) : row);
        if (row.empty() || row.front() == '#') continue;
        const std::string place = fmt::format("{}:{}:", file.string(), line);
        refuse_other_separators(row, place);
        if (header.empty()) {
            header = columns(row, place);
        } else {
            discs.push_back(disc(row, header, place));
        }
    }
    if (discs.empty()) {
        throw InputError(
            fmt::format("{} holds no discs; expected the row \"x [um],y [um],radius "
                        "[um]\" and one disc a row",
                        file.string()));
    }
    return discs;
}

}  // namespace crawford
