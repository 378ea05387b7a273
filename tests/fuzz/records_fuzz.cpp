/// The file of a record store. It is read and added to, and what was added is found again.
#include <cstdlib>

#include "reports/record_store.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace crawford::reports;
    const auto file = crawford::fuzz::file_of(bytes, size, "study.jsonl");
    crawford::fuzz::must_answer([&] {
        RecordStore store(file.parent_path(), "print");
        store.newest("study");
        Record added;
        added.experiment = "study";
        store.add(added);
        RecordStore again(file.parent_path(), "print");
        if (!again.newest("study", added.setting)) std::abort();
    });
    return 0;
}
