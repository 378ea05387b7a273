#include "solver/linear_solvers/one_thread.hpp"

#include <omp.h>
#include <sys/mman.h>

#include <cstddef>
#include <mutex>
#include <new>
#include <vector>

extern "C" {
void openblas_set_num_threads(int count);
void* blas_memory_alloc(int position);
void blas_memory_free(void* space);
}

namespace crawford {

namespace {

/// \throws std::bad_alloc if there is no room for so many work spaces of OpenBLAS.
void look_for_room(std::size_t spaces) {
    constexpr std::size_t work_space = std::size_t{32} << 22;  // BUFFER_SIZE of OpenBLAS on x86_64
    const std::size_t size = spaces * work_space;
    void* const room =
        ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) throw std::bad_alloc();
    ::munmap(room, size);
}

/// Work space for a thread. OpenBLAS maps one when as many calls as it has spaces are under way, and
/// tries for ever where it cannot; it never gives one back. So there is one for each thread before
/// the thread calls it.
class WorkSpace {
public:
    WorkSpace() {
        const std::lock_guard lock(mutex());
        look_for_room(threads() + 1);
        std::vector<void*> spaces(++threads());
        for (void*& space : spaces) space = blas_memory_alloc(0);
        for (void* space : spaces) blas_memory_free(space);
    }
    ~WorkSpace() {
        const std::lock_guard lock(mutex());
        --threads();
    }
    WorkSpace(const WorkSpace&) = delete;
    WorkSpace(WorkSpace&&) = delete;
    WorkSpace& operator=(const WorkSpace&) = delete;
    WorkSpace& operator=(WorkSpace&&) = delete;

private:
    static std::mutex& mutex() {
        static std::mutex mutex;
        return mutex;
    }
    static std::size_t& threads() {
        static std::size_t threads = 0;
        return threads;
    }
};

}  // namespace

void use_one_thread() {
    thread_local const WorkSpace space;
    static_cast<void>(space);
    // No level of parallel regions may be active: a num_threads clause, as CHOLMOD's, overrides any
    // other setting.
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
}

}  // namespace crawford
