// What every linear solver promises: the solution of a positive definite matrix, and a failure where there is none.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/errors.hpp"
#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {
namespace {

/// -u'' at three points, with `corner` in the place of the last diagonal term.
SparseMatrix lower_triangle(double corner) {
    const std::vector<Eigen::Triplet<double>> terms = {
        {0, 0, 2.0}, {1, 0, -1.0}, {1, 1, 2.0}, {2, 1, -1.0}, {2, 2, corner}};
    SparseMatrix lower(3, 3);
    lower.setFromTriplets(terms.begin(), terms.end());
    return lower;
}

class EverySolver : public testing::TestWithParam<LinearSolverEntry> {
protected:
    std::unique_ptr<SpdSolver> solver_ = make_spd_solver(GetParam().kind, 1e-12);
};

TEST_P(EverySolver, SolvesAPositiveDefiniteMatrix) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
    solver_->solve(lower_triangle(2.0), Eigen::Vector3d(1.0, 1.0, 1.0), x);
    EXPECT_NEAR((x - Eigen::Vector3d(1.5, 2.0, 1.5)).norm(), 0.0, 1e-10);
}

/// A corner of 2/3 would make it singular; below, the energy of a displacement is negative.
TEST_P(EverySolver, RefusesAMatrixThatIsNotPositiveDefinite) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
    try {
        solver_->solve(lower_triangle(0.5), Eigen::Vector3d(1.0, 1.0, 1.0), x);
        FAIL() << x.transpose();
    } catch (const NumericalFailure& failure) {
        EXPECT_EQ(failure.fields().module, "linear solver");
        EXPECT_EQ(failure.fields().kind, FailureFields::Kind::not_positive_definite);
    }
}

TEST(ConjugateGradients, SayHowFarTheyCame) {
    const auto solver = make_spd_solver(LinearSolver::pcg, 1e-12);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(2);
    SparseMatrix singular(2, 2);  // x0 - x1 cannot be 1 and -1 at once
    const std::vector<Eigen::Triplet<double>> terms = {{0, 0, 1.0}, {1, 0, -1.0}, {1, 1, 1.0}};
    singular.setFromTriplets(terms.begin(), terms.end());
    try {
        solver->solve(singular, Eigen::Vector2d(1.0, 1.0), x);
        FAIL() << x.transpose();
    } catch (const NumericalFailure& failure) {
        EXPECT_EQ(failure.fields().kind, FailureFields::Kind::no_convergence);
        EXPECT_NE(std::string(failure.what()).find("relative residual after 20 iterations"),
                  std::string::npos)
            << failure.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Linear, EverySolver, testing::ValuesIn(linear_solvers),
                         [](const auto& solver) { return std::string(solver.param.name); });

}  // namespace
}  // namespace crawford
