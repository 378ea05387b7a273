/// Direct solvers: the pattern is analysed once, the numbers are factorised at every solve.
#pragma once

#include "solver/linear_solvers/spd_solver.hpp"

namespace crawford {

/// CHOLMOD, supernodal, METIS ordering: its cost depends on the pattern alone, not on the contrast
/// of the materials.
std::unique_ptr<SpdSolver> make_cholmod();

/// Eigen's simplicial LDLT: no library besides Eigen, no BLAS.
std::unique_ptr<SpdSolver> make_ldlt();

}  // namespace crawford
