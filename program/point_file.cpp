#include "program/point_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "solver/scene/units.hpp"

namespace crawford {

namespace {

/// value in `to` = offset + factor * number in `from`, divided where that is exact: -20 um is -2e-5 m
/// to the last digit, as who reads it back expects.
struct Conversion {
    double factor = 1.0, offset = 0.0;

    double operator()(double number) const {
        const double parts = std::round(1.0 / factor);
        const bool is_part = parts > 1.0 && std::abs(parts * factor - 1.0) < 1e-14;
        return offset + (is_part ? number / parts : factor * number);
    }
};

Conversion conversion(const std::string& from, const std::string& to) {
    if (from == to || (to == "1" && from == "-")) return {};
    const double offset = read_quantity("0 " + from, to);
    return {read_quantity("1 " + from, to) - offset, offset};
}

}  // namespace

std::size_t csv_column(const CsvTable& table, const std::string& name) {
    std::vector<std::string> known;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < table.header.size(); ++k) {
        known.push_back(csv_heading(table.header[k]).name);
        if (known.back() == name) found.push_back(k);
    }
    const std::string place = table.place(table.header_line);
    if (found.size() > 1)
        throw InputError(fmt::format("{} has the column \"{}\" twice", place, name));
    if (found.empty())
        throw InputError(
            fmt::format("{} has no column \"{}\"{}", place, name, suggestion(name, known)));
    return found.front();
}

std::vector<double> csv_quantities(const CsvTable& table, std::size_t column,
                                   const std::string& unit, const std::string& given) {
    const std::string own = csv_heading(table.header[column]).unit;
    const std::string from = given.empty() ? own : given;
    const std::string place = table.place(table.header_line);
    if (from.empty())
        throw InputError(fmt::format("{} the column \"{}\" has no unit; write \"{} [{}]\"", place,
                                     table.header[column], table.header[column], unit));
    Conversion to_si;
    try {
        to_si = conversion(from, unit);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} \"{}\" {}", place, table.header[column], error.what()));
    }
    std::vector<double> values;
    for (const CsvRow& row : table.rows)
        values.push_back(to_si(csv_number(row.cells[column], table.place(row.line))));
    return values;
}

std::vector<Eigen::Vector2d> csv_points(const CsvTable& table) {
    const auto x = csv_quantities(table, csv_column(table, "x"), "m");
    const auto y = csv_quantities(table, csv_column(table, "y"), "m");
    if (x.empty()) throw InputError(fmt::format("{} holds no points", table.file.string()));
    std::vector<Eigen::Vector2d> points;
    for (std::size_t k = 0; k < x.size(); ++k) points.emplace_back(x[k], y[k]);
    return points;
}

}  // namespace crawford
