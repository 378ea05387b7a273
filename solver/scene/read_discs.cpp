#include "solver/scene/read_discs.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "base/csv_table.hpp"
#include "base/errors.hpp"
#include "solver/scene/units.hpp"

namespace crawford {

namespace {

struct Column {
    double Disc::*member;
    std::string unit;
};

constexpr std::array<std::pair<std::string_view, double Disc::*>, 3> members{
    {{"x", &Disc::x}, {"y", &Disc::y}, {"radius", &Disc::radius}}};

/// "radius [um]" is the member `radius` in um.
Column column(const std::string& heading, const std::string& place) {
    const CsvHeading read = csv_heading(heading);
    for (const auto& [name, member] : members)
        if (read.name == name && !read.unit.empty()) return {member, read.unit};
    throw InputError(
        fmt::format("{} has the column \"{}\"; a table of discs begins with the row \"x [um],y "
                    "[um],radius [um]\", in any unit of length",
                    place, heading));
}

std::vector<Column> columns(const CsvTable& table) {
    const std::string place = table.place(table.header_line);
    std::vector<Column> columns;
    std::vector<double Disc::*> seen;
    for (const std::string& heading : table.header) {
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

Disc disc(const CsvRow& row, const std::vector<Column>& columns, const std::string& place) {
    Disc disc{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        csv_number(row.cells[i], place);
        const std::string quantity = row.cells[i] + " " + columns[i].unit;
        try {
            disc.*columns[i].member = read_quantity(quantity, "m");
        } catch (const InputError& error) {
            throw InputError(fmt::format("{} \"{}\" {}", place, quantity, error.what()));
        }
    }
    return disc;
}

CsvTable read_table(const std::filesystem::path& file) {
    if (!std::ifstream(file))
        throw InputError(
            fmt::format("{} cannot be opened; check the name and that it may be read, the path "
                        "being relative to the scene file",
                        file.string()));
    return read_csv(file);
}

}  // namespace

std::vector<Disc> read_discs(const std::filesystem::path& file) {
    const CsvTable table = read_table(file);
    const std::vector<Column> header = columns(table);
    std::vector<Disc> discs;
    for (const CsvRow& row : table.rows) discs.push_back(disc(row, header, table.place(row.line)));
    if (discs.empty()) {
        throw InputError(
            fmt::format("{} holds no discs; expected the row \"x [um],y [um],radius "
                        "[um]\" and one disc a row",
                        file.string()));
    }
    return discs;
}

}  // namespace crawford
