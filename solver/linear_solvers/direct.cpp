/// Direct solvers: the pattern is analysed once, the numbers are factorised at every solve.
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>
#include <mutex>
#include <new>
#include <optional>
#include <vector>

#include "base/errors.hpp"
#include "solver/linear_solvers/one_thread.hpp"
#include "solver/linear_solvers/permuted_matrix.hpp"
#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {

namespace {

/// CHOLMOD tells of memory that it does not get by its status alone: the matrix is not to blame.
template <class Factorisation>
void refuse_short_memory(Factorisation& factorisation) {
    if constexpr (requires { factorisation.cholmod(); })
        if (factorisation.cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
}

/// METIS seeds the C library's one generator at each call and draws from it: two analyses at once
/// would draw from each other's, order the unknowns in another way each time, and a run would not
/// have the same bits again.
template <class Factorisation>
void analyse(Factorisation& factorisation, const SparseMatrix& lower) {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    factorisation.analyzePattern(lower);
    refuse_short_memory(factorisation);
}

/// L D L^T is found of any symmetric matrix: the signs of D tell.
template <class Factorisation>
bool is_positive_definite(const Factorisation& factorisation) {
    if (factorisation.info() != Eigen::Success) return false;
    if constexpr (requires { factorisation.vectorD(); })
        return (factorisation.vectorD().array() > 0.0).all();
    return true;
}

template <class Factorisation>
void factorise(Factorisation& factorisation, const SparseMatrix& lower) {
    factorisation.factorize(lower);
    refuse_short_memory(factorisation);
    if (!is_positive_definite(factorisation)) throw not_positive_definite();
}

using Supernodal = Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower>;

class Factor : public Supernodal {
public:
    explicit Factor(int ordering) {
        cholmod().nmethods = 1;
        cholmod().method[0].ordering = ordering;
        cholmod().print = 0;  // failures are exceptions, not lines on the terminal
    }

    /// Which unknown comes first, second, ... after analyzePattern().
    std::vector<int> order() const {
        const auto* const first = static_cast<const int*>(m_cholmodFactor->Perm);
        return {first, first + m_cholmodFactor->n};
    }
};

/// Nested dissection orders the unknowns once; the matrix is then handed over in that order. Left
/// to itself CHOLMOD would permute it at each factorisation, by transposing it twice, which takes a
/// quarter of the time. Order, factor and every bit are the same.
class Cholmod : public SpdSolver {
public:
    Cholmod() : factor_(CHOLMOD_NATURAL) {
        factor_.cholmod().postorder = 0;  // the order that is given has been postordered
    }

    int solve(const SparseMatrix& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
        const Calls calls = use_one_thread();
        if (!matrix_) begin(lower);
        factorise(factor_, matrix_->of(lower));
        x = matrix_->restored(factor_.solve(matrix_->permuted(b)));
        return 0;
    }

private:
    void begin(const SparseMatrix& lower) {
        Factor dissection(CHOLMOD_METIS);
        analyse(dissection, lower);
        matrix_.emplace(lower, dissection.order());
        analyse(factor_, matrix_->of(lower));
    }

    Factor factor_;
    std::optional<PermutedMatrix> matrix_;
};

class Ldlt : public SpdSolver {
public:
    int solve(const SparseMatrix& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
        if (!analysed_) analyse(factor_, lower);
        analysed_ = true;
        factorise(factor_, lower);
        x = factor_.solve(b);
        return 0;
    }

private:
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> factor_;
    bool analysed_ = false;
};

}  // namespace

std::unique_ptr<SpdSolver> make_cholmod(double) {
    return std::make_unique<Cholmod>();
}

std::unique_ptr<SpdSolver> make_ldlt(double) {
    return std::make_unique<Ldlt>();
}

}  // namespace crawford
