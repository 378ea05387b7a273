/// What each node of the surface stands for.
#pragma once

#include <cmath>

#include "solver/mesh/grid.hpp"

namespace crawford {

/// The true length of surface that each node column stands for [m]: half of every segment beside
/// it.
inline SurfaceField node_lengths(const Grid& grid, const SurfaceField& surface) {
    SurfaceField lengths(surface.size(), 0.0);
    for (int i = 0; i < grid.cell_columns(); ++i) {
        const double half = 0.5 * grid.dx(i) * std::hypot(1.0, grid.slope(surface, i));
        lengths[size_t(i)] += half;
        lengths[size_t(grid.right_node(i))] += half;
    }
    return lengths;
}

}  // namespace crawford
