/// The history of a burn, which one that goes on reads.
#include "solver/files/history.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto file = crawford::fuzz::file_of(bytes, size, "history.csv");
    crawford::fuzz::must_answer([&] { crawford::read_history(file); });
    return 0;
}
