/// How much of a polygon a strip covers, exactly.
#pragma once

#include <array>

#include "solver/mesh/lattice.hpp"

namespace crawford {

/// Area [m^2] that the strip |x| <= half_width shares with a quadrilateral, corners counted
/// anticlockwise.
double strip_overlap(const std::array<Vector, 4>& corners, double half_width);

}  // namespace crawford
