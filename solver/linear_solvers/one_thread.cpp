#include "solver/linear_solvers/one_thread.hpp"

#include <omp.h>

extern "C" void openblas_set_num_threads(int count);

namespace crawford {

void use_one_thread() {
    // No level of parallel regions may be active: a num_threads clause, as CHOLMOD's, overrides any
    // other setting.
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
}

}  // namespace crawford
