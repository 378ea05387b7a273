/// What an earlier `verify` found, as `verify --against` and `report` read it, down to the page.
#include "reports/against.hpp"
#include "reports/page/report.hpp"
#include "reports/verification.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace crawford::reports;
    const auto file = crawford::fuzz::file_of(bytes, size, "verify.json");
    crawford::fuzz::must_answer([&] { page::report(read_verification(file)); });
    crawford::fuzz::must_answer([&] {
        const auto gates = read_gates(file);
        text(compare(gates, gates, {}, {}));
    });
    return 0;
}
