/// A linear operator on the nodes whose rows couple a node with its eight neighbours.
#pragma once

#include <algorithm>
#include <array>

#include "solver/mesh/cell.hpp"

namespace crawford {

/// Coefficients of one row: [column][row] of the neighbour, each -1, 0, 1 shifted by one.
using StencilRow = std::array<std::array<double, 3>, 3>;

class NodeStencil {
public:
    explicit NodeStencil(const Grid& grid)
        : grid_(grid), rows_(grid.node_columns(), grid.rows() + 1) {}

    void clear() { std::ranges::fill(rows_.values(), StencilRow{}); }

    /// Adds to the row of corner `p` of cell (i, j) the coefficient of corner `q`.
    void add(const std::array<Node, 4>& nodes, int p, int q, double value) {
        // A slab is one column whose cells have it on both sides: its neighbour is itself.
        const int across = grid_.cell_columns() == 1 ? 0 : q % 2 - p % 2;
        const Node& row = nodes[size_t(p)];
        rows_(row.i, row.j)[size_t(across + 1)][size_t(q / 2 - p / 2 + 1)] += value;
    }

    StencilRow& row(int i, int j) { return rows_(i, j); }
    const StencilRow& row(int i, int j) const { return rows_(i, j); }

    /// Sum over the three neighbours in the column `side` (-1, 0, 1) of column i.
    double column_sum(const NodeField& field, int i, int j, int side) const {
        const auto& c = rows_(i, j)[size_t(side + 1)];
        const int column = neighbour(i, side);
        if (column < 0) return 0.0;
        double sum = c[1] * field(column, j);
        if (j > 0) sum += c[0] * field(column, j - 1);
        if (j + 1 < field.rows()) sum += c[2] * field(column, j + 1);
        return sum;
    }

    /// The operator applied to a field, at one node.
    double apply(const NodeField& field, int i, int j) const {
        return column_sum(field, i, j, -1) + column_sum(field, i, j, 0) +
               column_sum(field, i, j, 1);
    }

private:
    /// The node column beside column i, or -1 beyond a plane of symmetry.
    int neighbour(int i, int side) const {
        const int n = grid_.node_columns();
        const int column = i + side;
        if (column >= 0 && column < n) return column;
        return grid_.sides() == Sides::periodic ? column - side * n : -1;
    }

    const Grid& grid_;
    Lattice<StencilRow> rows_;
};

}  // namespace crawford
