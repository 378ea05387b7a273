/// Conjugate gradients with Jacobi's preconditioner on a symmetric stencil, as the paper solves
/// (section 3.3.1).
#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>

#include "base/errors.hpp"
#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {

namespace {

class JacobiPcg : public SpdSolver {
public:
    explicit JacobiPcg(double tolerance) : tolerance_(tolerance) {}

    int solve(const SparseMatrix& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
        Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower, Eigen::DiagonalPreconditioner<double>>
            pcg;
        // The count grows with sqrt(K/mu) times the number of cells across; ten times the unknowns
        // is beyond any of them.
        const long limit = 10 * long(b.size());
        pcg.setTolerance(tolerance_);
        pcg.setMaxIterations(limit);
        pcg.compute(lower);
        x = pcg.solveWithGuess(b, x);
        if (pcg.info() != Eigen::Success || !x.allFinite())
            throw NumericalFailure(
                {.kind = FailureFields::Kind::no_convergence,
                 .module = "linear solver",
                 .quantity = fmt::format("relative residual after {} iterations", pcg.iterations()),
                 .value = pcg.error(),
                 .limit = FailureLimit{.value = tolerance_},
                 .advice = "take numerics.solver = \"cholmod\""});
        // x.Ax: an iteration sees no more of the matrix than its answer.
        if (b.dot(x) < 0.0) throw not_positive_definite();
        return int(pcg.iterations());
    }

private:
    double tolerance_;
};

}  // namespace

std::unique_ptr<SpdSolver> make_jacobi_pcg(double tolerance) {
    return std::make_unique<JacobiPcg>(tolerance);
}

}  // namespace crawford
