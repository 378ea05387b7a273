/// Tables of discs.
#include "solver/scene/read_discs.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto file = crawford::fuzz::file_of(bytes, size, "discs.csv");
    crawford::fuzz::must_answer([&] { crawford::read_discs(file); });
    return 0;
}
