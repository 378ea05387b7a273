#include "solver/linear_solvers/spd_solver.hpp"

#include <algorithm>
#include <stdexcept>

namespace crawford {

std::unique_ptr<SpdSolver> make_spd_solver(LinearSolver kind, double tolerance) {
    const auto found = std::ranges::find(linear_solvers, kind, &LinearSolverEntry::kind);
    if (found == linear_solvers.end()) throw std::logic_error("a linear solver without a maker");
    return found->make(tolerance);
}

}  // namespace crawford
