/// The sparse matrix of the projection: a nine-point stencil of 2 x 2 blocks on a pattern fixed
/// once.
#pragma once

#include <array>
#include <vector>

#include "solver/grid/grid.hpp"
#include "solver/linear_solvers/spd_solver.hpp"
#include "solver/projection/element.hpp"

namespace crawford {

class FixedPattern {
public:
    /// \param held unknowns whose value is zero: their row and column become those of the identity.
    FixedPattern(const Grid& grid, const std::vector<bool>& held);

    /// Unknown `component` (0 is u, 1 is v) of a node.
    int unknown(const Node& node, int component) const {
        return 2 * (node.i * (grid_.rows() + 1) + node.j) + component;
    }
    int unknowns() const { return 2 * grid_.node_columns() * (grid_.rows() + 1); }
    bool held(int unknown) const { return held_[size_t(unknown)]; }

    void clear();
    void add(int i, int j, const ElementMatrix& k);  ///< the element of cell (i, j)
    const SparseMatrix& lower() const { return matrix_; }

private:
    std::array<int, 8> cell_unknowns(int i, int j) const;
    int slot(int row, int column) const;

    const Grid& grid_;
    std::vector<bool> held_;
    SparseMatrix matrix_;
    std::vector<std::array<int, 36>>
        slots_;  ///< where a cell's lower triangle goes, -1 for nowhere
};

}  // namespace crawford
