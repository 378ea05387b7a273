/// Conjugate gradients with Jacobi's preconditioner on a symmetric stencil, as the paper solves
/// (section 3.3.1).
#pragma once

#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {

std::unique_ptr<SpdSolver> make_jacobi_pcg(double tolerance);

}  // namespace crawford
