/// Peaks that mean something on any grid.
#pragma once

#include "solver/mesh/lattice.hpp"

namespace crawford {

/// The largest value of a cell field, and its mean over what a disc of some radius about the peak
/// holds of the peak's own material. The value does not converge beside a singular corner, the mean
/// does; the other material is left out because its share of the disc depends on which cell beside
/// the interface happens to hold the peak.
struct Peak {
    double value;
    double mean;
    Vector place;  ///< centre of the cell [m]
};

/// `position`: nodes, one column and one row more than cells; `material`: fraction of the first
/// material in each cell. A disc that leaves the side of the window is cut there.
Peak peak(const NodeVectors& position, const CellField& material, const CellField& field,
          double radius);

/// The radius of the means that histories hold [m].
inline constexpr double peak_radius = 5e-6;

}  // namespace crawford
