/// Checkpoints.
#include "solver/files/checkpoint.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto file = crawford::fuzz::file_of(bytes, size, "checkpoint.h5");
    crawford::fuzz::must_answer([&] { crawford::load_checkpoint(file, "title = \"any\"\n"); });
    return 0;
}
