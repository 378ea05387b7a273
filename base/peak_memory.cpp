#include "base/peak_memory.hpp"

#include <sys/resource.h>

#include <fstream>

namespace crawford {

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

void forget_peak_memory() {
    // proc(5): writing 5 resets the high water mark of the resident set.
    std::ofstream("/proc/self/clear_refs") << '5';
}

}  // namespace crawford
