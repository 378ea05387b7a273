/// Values at places that all grids of a series share, each beside its truth.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/mesh/grid.hpp"

namespace crawford {

struct KnownValue {
    std::string name;  ///< what and where
    double value, truth;
};

/// A place as fractions of the columns and rows: (0, 1) is the left end of the surface.
struct Place {
    double across, up;
};

/// A node.
struct NodeIndex {
    int i, j;
};

/// The node at a place.
/// \throws std::invalid_argument if this grid has none there.
inline NodeIndex node_at(const Grid& grid, const Place& place) {
    const double i = place.across * grid.cell_columns(), j = place.up * grid.rows();
    if (i != std::floor(i) || j != std::floor(j))
        throw std::invalid_argument("a grid that has no node at a place it is asked for");
    return {int(i), int(j)};
}

/// What a field of cells is at a node between them, linear from centre to centre: of second order.
/// The node lies below the surface, above the bottom and, on a grid with sides, between them.
/// \param cell (i, j) -> value
template <class Cell>
double between_cells(const Grid& grid, const NodeIndex& node, const Cell& cell) {
    const int right = node.i, left = (node.i + grid.cell_columns() - 1) % grid.cell_columns();
    const double below = grid.height(node.j - 1), above = grid.height(node.j);
    const auto column = [&](int i) {
        return (above * cell(i, node.j - 1) + below * cell(i, node.j)) / (above + below);
    };
    return (grid.dx(right) * column(left) + grid.dx(left) * column(right)) /
           (grid.dx(left) + grid.dx(right));
}

}  // namespace crawford
