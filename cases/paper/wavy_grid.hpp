/// The grid below a wavy surface, where figures 1 and 2 look at it.
#pragma once

#include <cmath>
#include <numbers>

#include "solver/mesh/grid.hpp"

namespace crawford {

/// Height of the surface [m]: one cosine from side to side.
inline SurfaceField wave(const Grid& grid, double amplitude) {
    SurfaceField surface;
    for (int i = 0; i < grid.node_columns(); ++i)
        surface.push_back(amplitude * std::cos(2.0 * std::numbers::pi * grid.x(i) / grid.width()));
    return surface;
}

/// Place of a node below the surface [m]; the column beyond the last is the periodic first.
inline Vector place(const Grid& grid, const SurfaceField& surface, int i, int j) {
    return {grid.x(i), surface[size_t(i % grid.node_columns())] + grid.eta(j)};
}

}  // namespace crawford
