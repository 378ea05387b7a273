/// How much of a polygon a disc covers, exactly.
#pragma once

#include <array>

#include "solver/mesh/lattice.hpp"

namespace crawford {

/// Area [m^2] that a disc of `radius` about the origin shares with a quadrilateral, corners counted
/// anticlockwise.
double disc_overlap(const std::array<Vector, 4>& corners, double radius);

}  // namespace crawford
