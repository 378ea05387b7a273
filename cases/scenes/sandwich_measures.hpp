/// Numbers read off a sandwich.
#pragma once

#include "solver/files/snapshot.hpp"
#include "solver/run/peak.hpp"

namespace crawford {

/// The peak of one of the snapshot's cell fields.
inline Peak peak(const Snapshot& snapshot, const CellField& field, double radius) {
    return peak(snapshot.position, snapshot.material, field, radius);
}

/// How far a point of the surface has moved up from where it started [m].
double largest_outward_displacement(const Snapshot& snapshot);

}  // namespace crawford
