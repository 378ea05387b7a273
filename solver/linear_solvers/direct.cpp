#include "solver/linear_solvers/direct.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>

#include "solver/errors.hpp"
#include "solver/linear_solvers/one_thread.hpp"

namespace crawford {

namespace {

template <class Factorisation>
class Direct : public SpdSolver {
public:
    int solve(const SparseMatrix& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
        use_one_thread();
        if (!analysed_) factorisation_.analyzePattern(lower);
        analysed_ = true;
        factorisation_.factorize(lower);
        if (factorisation_.info() != Eigen::Success)
            throw NumericalFailure("linear solver: the matrix is not positive definite");
        x = factorisation_.solve(b);
        return 0;
    }

protected:
    Factorisation factorisation_;

private:
    bool analysed_ = false;
};

class Cholmod : public Direct<Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower>> {
public:
    Cholmod() {
        auto& options = factorisation_.cholmod();
        options.nmethods = 1;
        options.method[0].ordering = CHOLMOD_METIS;
        options.print = 0;  // failures are exceptions, not lines on the terminal
    }
};

using Ldlt = Direct<Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>>;

}  // namespace

std::unique_ptr<SpdSolver> make_cholmod() {
    return std::make_unique<Cholmod>();
}

std::unique_ptr<SpdSolver> make_ldlt() {
    return std::make_unique<Ldlt>();
}

}  // namespace crawford
