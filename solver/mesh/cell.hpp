/// One cell as a bilinear element: a parallelogram with vertical sides, so that its map is affine.
///
/// Local coordinates (a, b) in [0, 1]^2, a along the row and b upward. Corners are counted 0:
/// (0,0), 1: (1,0), 2: (0,1), 3: (1,1). The chain rule of the surface-following coordinates (paper
/// eq. 31) is all of the geometry there is:
///     d/dx|y = (1/dx) d/da - (slope/height) d/db,   d/dy = (1/height) d/db.
#pragma once

#include <array>

#include "solver/mesh/grid.hpp"

namespace crawford {

/// A node of the lattice.
struct Node {
    int i, j;
};

/// A place inside a cell.
struct Local {
    double a, b;
};

constexpr Local cell_centre{0.5, 0.5};

struct Cell {
    double dx, height, slope;

    Cell(const Grid& grid, const SurfaceField& surface, int i, int j)
        : dx(grid.dx(i)), height(grid.height(j)), slope(grid.slope(surface, i)) {}

    double area() const { return dx * height; }  ///< [m^2]

    /// The gradient in (x, y) of what has these derivatives in (a, b).
    Vector physical(double along_a, double along_b) const {
        const double y = along_b / height;
        return {along_a / dx - slope * y, y};
    }
};

/// The four nodes of cell (i, j), in the order of the corners.
inline std::array<Node, 4> corners(const Grid& grid, int i, int j) {
    const int right = grid.right_node(i);
    return {{{i, j}, {right, j}, {i, j + 1}, {right, j + 1}}};
}

/// The area that each node stands for [m^2]: a quarter of every cell around it.
inline NodeField node_areas(const Grid& grid) {
    NodeField areas(grid.node_columns(), grid.rows() + 1);
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j)
            for (const Node& node : corners(grid, i, j))
                areas(node.i, node.j) += 0.25 * grid.dx(i) * grid.height(j);
    return areas;
}

/// What a nodal field holds at the four corners of a cell.
template <class Value>
std::array<Value, 4> gather(const Lattice<Value>& field, const std::array<Node, 4>& nodes) {
    return {field(nodes[0].i, nodes[0].j), field(nodes[1].i, nodes[1].j),
            field(nodes[2].i, nodes[2].j), field(nodes[3].i, nodes[3].j)};
}

/// Bilinear interpolation of corner values.
template <class Value>
Value interpolate(const std::array<Value, 4>& f, Local at) {
    return (1 - at.b) * ((1 - at.a) * f[0] + at.a * f[1]) +
           at.b * ((1 - at.a) * f[2] + at.a * f[3]);
}

/// Gradient of a bilinear scalar.
inline Vector gradient(const Cell& cell, const std::array<double, 4>& f, Local at) {
    return cell.physical((1 - at.b) * (f[1] - f[0]) + at.b * (f[3] - f[2]),
                         (1 - at.a) * (f[2] - f[0]) + at.a * (f[3] - f[1]));
}

/// Gradient of a bilinear vector: row k holds the gradient of component k.
inline Eigen::Matrix2d gradient(const Cell& cell, const std::array<Vector, 4>& f, Local at) {
    const Vector along_a = (1 - at.b) * (f[1] - f[0]) + at.b * (f[3] - f[2]);
    const Vector along_b = (1 - at.a) * (f[2] - f[0]) + at.a * (f[3] - f[1]);
    Eigen::Matrix2d result;
    result.row(0) = cell.physical(along_a.x(), along_b.x());
    result.row(1) = cell.physical(along_a.y(), along_b.y());
    return result;
}

/// Gradients of the four hat functions.
inline std::array<Vector, 4> hat_gradients(const Cell& cell, Local at) {
    return {cell.physical(-(1 - at.b), -(1 - at.a)), cell.physical(1 - at.b, -at.a),
            cell.physical(-at.b, 1 - at.a), cell.physical(at.b, at.a)};
}

}  // namespace crawford
