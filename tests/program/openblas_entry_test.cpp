// The count of cores that OpenBLAS is given, by tests and program: it starts a thread for each but one.
#include <gtest/gtest.h>

extern "C" int openblas_get_num_procs();

namespace crawford {
namespace {

TEST(OpenblasEntry, LeavesOpenblasOneCore) {
    EXPECT_EQ(openblas_get_num_procs(), 1);
}

}  // namespace
}  // namespace crawford
