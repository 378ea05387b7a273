/// What `crawford run --movie` refuses. Drawing a movie takes a burn and is left to
/// whoever wants to see it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/process.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"
#include "tests/program_path.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;

TEST(ProgramMovie, IsRefusedInOneLineWhereACaseHasNone) {
    const Scratch scratch;
    const auto out = scratch.path() / "out";
    const auto run =
        run_program({program_path(), "run", "fig13", "fig01", "--movie", "--out", out.string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.output, testing::HasSubstr("--movie: fig01 has no movie; fig13 has"));
    EXPECT_EQ(std::ranges::count(run.output, '\n'), 1);
    EXPECT_FALSE(fs::exists(out)) << "nothing is begun";
}

}  // namespace
}  // namespace crawford
