#include "solver/linear_solvers/spd_solver.hpp"

#include <stdexcept>

#include "solver/linear_solvers/direct.hpp"
#include "solver/linear_solvers/jacobi_pcg.hpp"

namespace crawford {

std::unique_ptr<SpdSolver> make_spd_solver(LinearSolver kind, double tolerance) {
    switch (kind) {
        case LinearSolver::cholmod:
            return make_cholmod();
        case LinearSolver::ldlt:
            return make_ldlt();
        case LinearSolver::pcg:
            return make_jacobi_pcg(tolerance);
    }
    throw std::logic_error("a linear solver without a maker");
}

}  // namespace crawford
