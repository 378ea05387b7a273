/// The manifest of a burn, which one that goes on reads, and a table of many.
#include "solver/files/kept_manifest.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto file = crawford::fuzz::file_of(bytes, size, "manifest.json");
    crawford::fuzz::must_answer([&] { crawford::kept_manifest(file.parent_path()); });
    return 0;
}
