#include "base/peak_memory.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <fstream>

namespace crawford {

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

void forget_peak_memory() {
    malloc_trim(0);  // what is free already counts no more
    // proc(5): writing 5 resets the high water mark of the resident set.
    std::ofstream("/proc/self/clear_refs") << '5';
}

}  // namespace crawford
