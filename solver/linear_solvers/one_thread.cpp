#include "solver/linear_solvers/one_thread.hpp"

#include <omp.h>
#include <sys/mman.h>

#include <cstddef>
#include <new>

extern "C" void openblas_set_num_threads(int count);

namespace crawford {

namespace {

/// Where OpenBLAS cannot map its work space it tries again for ever.
/// \throws std::bad_alloc if there is no room for that of one more thread.
bool look_for_room() {
    constexpr std::size_t work_space = std::size_t{32} << 22;  // BUFFER_SIZE of OpenBLAS on x86_64
    void* const room =
        ::mmap(nullptr, work_space, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) throw std::bad_alloc();
    ::munmap(room, work_space);
    return true;
}

}  // namespace

void use_one_thread() {
    // It keeps what it has mapped: each thread needs to look once.
    thread_local const bool has_room = look_for_room();
    static_cast<void>(has_room);
    // No level of parallel regions may be active: a num_threads clause, as CHOLMOD's, overrides any
    // other setting.
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
}

}  // namespace crawford
