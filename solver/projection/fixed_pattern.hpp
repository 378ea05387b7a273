/// The sparse matrix of the projection on a pattern fixed once: cells couple their four nodes,
/// patches their nine.
#pragma once

#include <vector>

#include "solver/element/checkerboard.hpp"
#include "solver/linear_solvers/spd_solver.hpp"
#include "solver/mesh/cell.hpp"

namespace crawford {

class FixedPattern {
public:
    /// \param held unknowns whose value is zero: their row and column become those of the identity.
    /// \param patches that may be added besides the cells.
    /// \param without_centres the node in the middle of each patch has no equation
    FixedPattern(const Grid& grid, std::vector<bool> held, const std::vector<Patch>& patches,
                 bool without_centres = false);

    /// Unknown `component` (0 is u, 1 is v) of a node.
    int unknown(const Node& node, int component) const {
        return 2 * (node.i * (grid_.rows() + 1) + node.j) + component;
    }
    int unknowns() const { return 2 * grid_.node_columns() * (grid_.rows() + 1); }
    bool held(int unknown) const { return held_[size_t(unknown)]; }

    /// What the unknowns with an equation hold, in the order of the matrix; and put back, the others
    /// left as they are.
    Eigen::VectorXd gathered(const Eigen::VectorXd& of_all) const { return of_all(with_equation_); }
    void scatter(const Eigen::VectorXd& values, Eigen::VectorXd& of_all) const {
        of_all(with_equation_) = values;
    }

    void clear();

    /// Adds the symmetric matrix of block number `block`: the cells in the order of the lattice,
    /// then the patches. Rows and columns are (node 0 x, node 0 y, node 1 x, ...).
    template <class Matrix>
    void add(size_t block, const Matrix& k) {
        const Block& target = blocks_[block];
        const int size = int(k.rows());
        size_t next = target.first;
        for (int p = 0; p < size; ++p)
            for (int q = 0; q <= p; ++q) {
                const Slot& slot = slots_[next++];
                if (slot.index >= 0) matrix_.valuePtr()[slot.index] += slot.weight * k(p, q);
            }
    }

    const SparseMatrix& lower() const { return matrix_; }

private:
    struct Block {
        size_t first;               ///< of its slots
        std::vector<int> unknowns;  ///< of the nodes, u before v
    };
    struct Slot {
        int index;      ///< among the matrix's values; -1 for nowhere
        double weight;  ///< 2 where both triangles of a block fall on the matrix's diagonal, else 1
    };

    template <class Nodes>
    void append(const Nodes& nodes);
    void reserve_pattern();
    void find_slots();
    int position(int row, int column) const;

    bool is_free(int unknown) const { return !held(unknown) && equation_[size_t(unknown)] >= 0; }
    void number(const std::vector<Patch>& without_centres);

    const Grid& grid_;
    std::vector<bool> held_;
    std::vector<int> equation_;       ///< of each unknown; -1 where it has none
    std::vector<int> with_equation_;  ///< unknowns, in the order of the equations
    SparseMatrix matrix_;
    std::vector<Block> blocks_;
    std::vector<Slot> slots_;
};

}  // namespace crawford
