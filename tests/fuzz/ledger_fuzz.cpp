/// A settled ledger, as `ledger` and `report` read it, down to its lines and its page.
#include "reports/ledger.hpp"
#include "reports/ledger_line.hpp"
#include "reports/page/ledger.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace crawford::reports;
    const auto file = crawford::fuzz::file_of(bytes, size, "ledger.json");
    crawford::fuzz::must_answer([&] {
        const Ledger ledger = read_ledger(file);
        for (const LedgerRow& row : ledger.rows) line_of(row);
        page::ledger_page(ledger, {"fig09"});
    });
    return 0;
}
