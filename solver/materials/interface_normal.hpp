/// Which way an interface faces, from the volume fractions around it.
#pragma once

#include "solver/mesh/cell.hpp"

namespace crawford {

/// Unit normal of the interface in cell (i, j): the gradient of the fractions of the nine cells
/// about it, weighted 1, 2, 1 across the difference (Youngs 1982). Zero where they have none.
Vector interface_normal(const Grid& grid, const SurfaceField& surface, const CellField& fraction,
                        int i, int j);

}  // namespace crawford
