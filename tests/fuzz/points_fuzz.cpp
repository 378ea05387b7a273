/// Tables of points and fields in CSV, as judge and truth read them.
#include "program/point_file.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto file = crawford::fuzz::file_of(bytes, size, "points.csv");
    crawford::fuzz::must_answer([&] {
        const auto table = crawford::read_csv(file);
        crawford::csv_points(table);
        for (std::size_t column = 0; column < table.header.size(); ++column)
            crawford::csv_quantities(table, column, "K");
    });
    return 0;
}
