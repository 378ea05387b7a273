/// Norms of an error field: one number from the values at all points.
///
/// L1 and L2 are means over the domain, sum(w |e|)/sum(w) and sqrt(sum(w e^2)/sum(w)), so they
/// carry the unit of the field and do not change with the size of the domain. The weight w is the
/// size of the cell that a value stands for: on a clustered grid an unweighted sum counts the fine
/// cells more than they are worth. A NaN among the values is a NaN of the norm, in every norm.
#pragma once

#include <span>
#include <string_view>

namespace crawford::reports {

// NOLINTBEGIN(readability-identifier-naming): these are the names of the field.
enum class Norm {
    L1,         ///< Mean of |e|, weighted by cell size
    L2,         ///< Root of the mean of e^2, weighted by cell size
    Linf,       ///< Largest |e|
    paper,      ///< Root mean square over the points, unweighted (paper eq. 55)
    magnitude,  ///< |e| of a single number, such as a surface temperature
};
// NOLINTEND(readability-identifier-naming)

/// The name as printed in tables: "L1", "L2", "Linf", "eq.55", "|.|".
std::string_view name(Norm norm);

/// \throws std::invalid_argument if no norm is printed so.
Norm norm_named(std::string_view name);

/// Norm of `values` with the cell sizes `weights` [m or m^2, >= 0]; no weights means all alike.
/// \throws std::invalid_argument if there are no values, if the lengths differ, if a weight is
/// negative or none is positive, or if `magnitude` is asked of more than one value.
double norm(Norm norm, std::span<const double> values, std::span<const double> weights = {});

/// Norm of values - truth, point by point.
/// \throws std::invalid_argument as norm(), or if the lengths differ.
double distance(Norm norm, std::span<const double> values, std::span<const double> truth,
                std::span<const double> weights = {});

}  // namespace crawford::reports
