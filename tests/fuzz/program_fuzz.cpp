/// The program itself with a broken file of a mesh. HDF5 may break on it, the program may not: it ends with 0 or 2.
#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "base/process.hpp"
#include "tests/fuzz/contract.hpp"

namespace {

void must_end_well(const std::vector<std::string>& command) {
    constexpr int done = 0, input_is_wrong = 2;
    const auto finished = crawford::run_program(command);
    if (finished.status == done || finished.status == input_is_wrong) return;
    std::cerr << fmt::format("exit code {}: {}\n", finished.status, finished.output);
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const char* program = std::getenv("CRAWFORD_PROGRAM");
    if (program == nullptr) std::abort();
    const auto file = crawford::fuzz::file_of(bytes, size, "mesh.hdf").string();
    must_end_well({program, "points", file});
    must_end_well({program, "judge", "slab", "16=" + file});
    return 0;
}
