/// Quantities with units, each read as several dimensions.
#include "solver/scene/units.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    for (const char* unit : {"m", "Pa", "W/m2", "K", "1"})
        crawford::fuzz::must_answer(
            [&] { crawford::read_quantity(crawford::fuzz::text_of(bytes, size), unit); });
    return 0;
}
