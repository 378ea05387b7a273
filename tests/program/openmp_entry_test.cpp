// The entry into OpenMP regions that tests and program link: it calls a region itself where no level
// of parallelism is allowed, and else hands it to libgomp.
#include <gtest/gtest.h>
#include <omp.h>

#include <atomic>

namespace crawford {
namespace {

/// Threads that a region for two runs on, with so many levels of parallel regions allowed.
int threads_with(int levels) {
    const int before = omp_get_max_active_levels();
    const int dynamic = omp_get_dynamic();
    omp_set_dynamic(0);
    omp_set_max_active_levels(levels);
    std::atomic<int> threads{0};
#pragma omp parallel num_threads(2)
    ++threads;
    omp_set_max_active_levels(before);
    omp_set_dynamic(dynamic);
    return threads;
}

TEST(OpenmpEntry, CallsTheRegionWhereNoLevelIsAllowedAndElseHandsItOn) {
    EXPECT_EQ(threads_with(0), 1);
    EXPECT_EQ(threads_with(1), 2);
}

}  // namespace
}  // namespace crawford
