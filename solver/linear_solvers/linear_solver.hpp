/// The linear solvers that there are: one table. A new one is a row here and a file beside.
#pragma once

#include <array>
#include <memory>

namespace crawford {

class SpdSolver;

enum class LinearSolver {
    cholmod,  ///< supernodal Cholesky, factorised anew each step on a fixed pattern
    ldlt,     ///< Eigen's simplicial LDLT
    pcg       ///< Jacobi-preconditioned conjugate gradients, the paper's (section 3.3.1)
};

/// CHOLMOD, METIS ordering: its cost depends on the pattern alone, not on the contrast of the
/// materials.
std::unique_ptr<SpdSolver> make_cholmod(double tolerance);
/// No library besides Eigen, no BLAS.
std::unique_ptr<SpdSolver> make_ldlt(double tolerance);
std::unique_ptr<SpdSolver> make_jacobi_pcg(double tolerance);

struct LinearSolverEntry {
    LinearSolver kind;
    const char* name;  ///< in a scene
    /// \param tolerance relative residual |b - A x|/|b| at which an iterative solver stops; a
    /// direct one has no use for it.
    std::unique_ptr<SpdSolver> (*make)(double tolerance);
};

inline constexpr std::array linear_solvers{
    LinearSolverEntry{LinearSolver::cholmod, "cholmod", make_cholmod},
    LinearSolverEntry{LinearSolver::ldlt, "ldlt", make_ldlt},
    LinearSolverEntry{LinearSolver::pcg, "pcg", make_jacobi_pcg}};

}  // namespace crawford
