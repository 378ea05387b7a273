#include "base/peak_memory.hpp"

#include <sys/resource.h>

namespace crawford {

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

}  // namespace crawford
