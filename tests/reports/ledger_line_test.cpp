/// A row of the ledger on a terminal says all that its number needs.
#include "reports/ledger_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace crawford::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

LedgerRow row(const std::string& unit = "cm/s") {
    return {.claim = "mean burn rate of the pack",
            .where = "Fig. 15b",
            .unit = unit,
            .paper = "0.42",
            .ours = "0.416",
            .paper_value = 0.42,
            .value = 0.416,
            .uncertainty = {.grid = 0.003, .step = 0.004, .packs = 0.0},
            .standing = Standing::reproduced};
}

TEST(LedgerLine, HasBothNumbersWithUnitAndInterval) {
    const auto line = line_of(row());
    for (const char* part : {"Fig. 15b", "mean burn rate of the pack", "0.42 cm/s",
                             "0.416 \u00b1 0.005 cm/s", "reproduced"})
        EXPECT_THAT(line, HasSubstr(part));
    EXPECT_THAT(line, Not(HasSubstr("\n")));
}

TEST(LedgerLine, SaysWhereNoIntervalWasStudiedOrNoneIsNeeded) {
    auto other = row();
    other.uncertainty = {};
    EXPECT_THAT(line_of(other), HasSubstr("0.416 cm/s, not studied"));
    other.uncertainty = {.grid = 0.0, .step = 0.0};
    EXPECT_THAT(line_of(other), HasSubstr("0.416 cm/s "));
    EXPECT_THAT(line_of(row("-")), Not(HasSubstr("cm/s")));
}

TEST(LedgerLine, KeepsWords) {
    const auto line = line_of({.claim = "stress is confined",
                               .where = "Fig. 9",
                               .unit = "-",
                               .paper = "to AP",
                               .ours = "to AP, 98 %",
                               .standing = Standing::not_reproduced});
    EXPECT_THAT(line, HasSubstr("to AP, 98 %"));
    EXPECT_THAT(line, HasSubstr("not reproduced"));
}

}  // namespace
}  // namespace crawford::reports
