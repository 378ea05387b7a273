/// Which velocities are held at zero: the bottom, the planes of symmetry, and what keeps the solid
/// from drifting.
#pragma once

#include <vector>

#include "solver/mesh/grid.hpp"

namespace crawford {

/// One flag for each unknown, in the order of FixedPattern: nodes column by column, u before v.
std::vector<bool> held_unknowns(const Grid& grid, Support support);

}  // namespace crawford
