/// An entry into OpenMP regions that costs nothing where one thread runs them.
///
/// CHOLMOD opens some 20,900 parallel regions in a factorisation of a pack's projection. With no
/// level of parallel regions active (solver/linear_solvers/one_thread.hpp) each runs on the thread
/// that opens it, and what libgomp spends on opening it, up to 1.5 us, is more than what most of them do.
/// Here the thread just calls the region: it is outside of any region and so already sees itself as
/// thread 0 of 1, which is all that CHOLMOD asks for. The arithmetic, and every bit, stay the same.
///
/// This takes the place of libgomp's entry for the whole process. That is a program's choice: the
/// file is linked into programs, as an object of its own, and never part of a library.

#include <dlfcn.h>
#include <omp.h>

extern "C" {

/// The outlined region, its data, how many threads it asks for (0: as many as it gets) and flags.
/// Named and declared by GCC's OpenMP interface (libgomp, "Implementing PARALLEL construct").
void GOMP_parallel(void (*region)(void*), void* data, unsigned threads,  // NOLINT
                   unsigned flags) {
    if (omp_get_max_active_levels() == 0) {
        region(data);
        return;
    }
    using Entry = void (*)(void (*)(void*), void*, unsigned, unsigned);
    static const auto libgomp = reinterpret_cast<Entry>(dlsym(RTLD_NEXT, "GOMP_parallel"));
    libgomp(region, data, threads, flags);
}
}
