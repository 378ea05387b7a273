/// A symmetric matrix with its unknowns in another order, worked out once for a pattern that stays.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {

class PermutedMatrix {
public:
    /// \param order order[k] is the unknown that becomes number k.
    PermutedMatrix(const SparseMatrix& lower, const std::vector<int>& order);

    /// Takes the values of a matrix of the same pattern.
    /// \returns the lower triangle, by columns, rows ascending.
    const SparseMatrix& of(const SparseMatrix& lower);

    Eigen::VectorXd permuted(const Eigen::VectorXd& x) const;
    Eigen::VectorXd restored(const Eigen::VectorXd& x) const;

private:
    Eigen::VectorXi order_;
    std::vector<int> source_;  ///< of each value of the permuted matrix, its place in the original
    SparseMatrix permuted_;
};

}  // namespace crawford
