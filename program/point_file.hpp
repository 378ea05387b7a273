/// Points and fields from CSV files, in SI.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/csv_table.hpp"

namespace crawford {

/// The column called `name`, whatever its unit.
/// \throws InputError naming the nearest heading, if there is none or two.
std::size_t csv_column(const CsvTable& table, const std::string& name);

/// A column in `unit`; `given` replaces the unit of its heading where that has none.
/// \throws InputError naming file and line.
std::vector<double> csv_quantities(const CsvTable& table, std::size_t column,
                                   const std::string& unit, const std::string& given = "");

/// The columns x and y [m].
std::vector<Eigen::Vector2d> csv_points(const CsvTable& table);

}  // namespace crawford
