/// Numbers read off a sandwich.
#pragma once

#include "solver/output/snapshot.hpp"

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
Peak peak(const Snapshot& snapshot, const CellField& field, double radius);

/// How far a point of the surface has moved up from where it started [m].
double largest_outward_displacement(const Snapshot& snapshot);

}  // namespace crawford
