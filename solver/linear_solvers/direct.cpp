/// Direct solvers: the pattern is analysed once, the numbers are factorised at every solve.
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>
#include <mutex>

#include "base/errors.hpp"
#include "solver/linear_solvers/one_thread.hpp"
#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {

namespace {

template <class Factorisation>
class Direct : public SpdSolver {
public:
    int solve(const SparseMatrix& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
        use_one_thread();
        if (!analysed_) analyse(lower);
        analysed_ = true;
        factorisation_.factorize(lower);
        if (factorisation_.info() != Eigen::Success)
            throw NumericalFailure({.kind = FailureFields::Kind::not_positive_definite,
                                    .module = "linear solver",
                                    .quantity = "the matrix"});
        x = factorisation_.solve(b);
        return 0;
    }

protected:
    Factorisation factorisation_;

private:
    /// METIS seeds the C library's one generator at each call and draws from it: two analyses at
    /// once would draw from each other's, order the unknowns in another way each time, and a run
    /// would not have the same bits again.
    void analyse(const SparseMatrix& lower) {
        static std::mutex one_at_a_time;
        const std::scoped_lock lock(one_at_a_time);
        factorisation_.analyzePattern(lower);
    }

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

std::unique_ptr<SpdSolver> make_cholmod(double) {
    return std::make_unique<Cholmod>();
}

std::unique_ptr<SpdSolver> make_ldlt(double) {
    return std::make_unique<Ldlt>();
}

}  // namespace crawford
