/// What an earlier `verify` found, as `verify --against` reads it.
#include "reports/verification.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto file = crawford::fuzz::file_of(bytes, size, "verify.json");
    crawford::fuzz::must_answer([&] { crawford::reports::read_verification(file); });
    crawford::fuzz::must_answer([&] { crawford::reports::read_gates(file); });
    return 0;
}
