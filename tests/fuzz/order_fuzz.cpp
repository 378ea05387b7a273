/// Tables of errors or values over grids: read, judged, told as text and as JSON.
#include <nlohmann/json.hpp>

#include "reports/order_json.hpp"
#include "reports/order_judgement.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace crawford::reports;
    const auto file = crawford::fuzz::file_of(bytes, size, "order.csv");
    crawford::fuzz::must_answer([&] {
        const auto table = order_table(crawford::read_csv(file), 1);
        const OrderQuestion question{
            .expected = expect(2.0).within(0.1), .reason = "asked for", .size = 1.0};
        std::vector<JudgedColumn> columns;
        for (const OrderColumn& column : table.columns) {
            columns.push_back(judge(table, column, question));
            text(table, columns.back());
        }
        order_json(columns).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    });
    return 0;
}
