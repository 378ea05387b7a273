/// Solvers of sparse symmetric positive definite systems whose pattern never changes. They know no
/// physics.
#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "base/errors.hpp"
#include "solver/linear_solvers/linear_solver.hpp"

namespace crawford {

/// Lower triangle, by columns.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

class SpdSolver {
public:
    virtual ~SpdSolver() = default;

    /// Solves A x = b. `x` enters as the first guess.
    /// \returns the number of iterations, 0 for a direct solver.
    /// \throws NumericalFailure if A is not positive definite, which an iterative solver may miss
    /// where x.Ax > 0, or if the iteration does not converge.
    virtual int solve(const SparseMatrix& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) = 0;
};

/// What a solver throws of a matrix that is not positive definite.
inline NumericalFailure not_positive_definite() {
    return NumericalFailure({.kind = FailureFields::Kind::not_positive_definite,
                             .module = "linear solver",
                             .quantity = "the matrix"});
}

/// \param tolerance relative residual |b - A x|/|b| at which an iterative solver stops.
std::unique_ptr<SpdSolver> make_spd_solver(LinearSolver kind, double tolerance);

}  // namespace crawford
