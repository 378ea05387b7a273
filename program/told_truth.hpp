/// Truths of the registry, asked for from a command line.
#pragma once

#include <string>
#include <vector>

#include "base/csv_table.hpp"
#include "reference/truth_registry.hpp"

namespace crawford {

/// The truth with the parameters "key=value", values with their units.
/// \throws InputError naming truth and parameter.
reference::Truth told_truth(const reference::TruthEntry& entry,
                            const std::vector<std::string>& set);

/// All fields at the points of a table.
/// \throws InputError naming file and line of a point that is outside.
reference::FieldTable told_values(const reference::Truth& truth, const CsvTable& table,
                                  const std::vector<Eigen::Vector2d>& points, double time);

/// A time with its unit, as "2 ms" [s]. \throws InputError
double told_time(const std::string& time);

/// Description, source, parameters (unit, limits, what holds if not given) and fields.
std::string described(const reference::TruthEntry& entry);

/// "from 0 to 1 m", or "any", of a parameter.
std::string limits_of(const reference::Parameter& parameter);

/// What holds where a parameter is not given.
std::string standard_of(const reference::Parameter& parameter);

}  // namespace crawford
