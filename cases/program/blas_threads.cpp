#include "cases/program/blas_threads.hpp"

#include <dlfcn.h>

namespace crawford {

void use_one_blas_thread() {
    using SetThreads = void (*)(int);
    const auto set = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
    if (set) set(1);
}

}  // namespace crawford
