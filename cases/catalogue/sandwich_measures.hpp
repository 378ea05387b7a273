/// Numbers read off a sandwich.
#pragma once

#include "solver/output/snapshot.hpp"

namespace crawford {

/// The largest value of a cell field, and the mean over the cells whose centres lie within a radius
/// of it, weighted by area. The value does not converge beside a singular corner, the mean does.
struct Peak {
    double value;
    double mean;
    Vector place;  ///< centre of the cell [m]
};
Peak peak(const Snapshot& snapshot, const CellField& field, double radius);

/// How far a point of the surface has moved up from where it started [m].
double largest_outward_displacement(const Snapshot& snapshot);

}  // namespace crawford
