/// What a table of comma-separated text may look like, and what is refused with its line.
#include "base/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/scratch.hpp"

namespace crawford {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CsvTable table_of(const std::string& text) {
    const Scratch scratch;
    write_file(scratch.path() / "table.csv", text);
    return read_csv(scratch.path() / "table.csv");
}

template <class Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

std::string refusal_of(const std::string& text) {
    return refusal([&] { table_of(text); });
}

TEST(CsvTable, ReadsWhatSpreadsheetsWrite) {
    const CsvTable table = table_of(
        "\xEF\xBB\xBF# a remark\r\n\r\n\"h [mm]\",\"T, say \"\"hot\"\"\"\r\n\"1\", 2.5 \r\n3,+4e2");
    EXPECT_THAT(table.header, ElementsAre("h [mm]", "T, say \"hot\""));
    EXPECT_EQ(table.header_line, 3);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_THAT(table.rows[0].cells, ElementsAre("1", "2.5"));
    EXPECT_EQ(table.rows[0].line, 4);
    EXPECT_EQ(csv_number(table.rows[1].cells[1], ""), 400.0);
}

TEST(CsvTable, RefusesWithTheLine) {
    EXPECT_THAT(refusal_of("h;e\n1;2\n"), HasSubstr("table.csv:1: has semicolons"));
    EXPECT_THAT(refusal_of("h,e\n1\t2\n"), HasSubstr("table.csv:2: has tabs"));
    EXPECT_THAT(refusal_of("h,e\n1,2\n\n1\n"), HasSubstr(":4: has 1 values; expected 2"));
    EXPECT_THAT(refusal_of("h,e\n1,\n"), HasSubstr(":2: the cell of column \"e\" is empty"));
    EXPECT_THAT(refusal_of("h,e\n1,\"2\n"), HasSubstr(":2: has a quote that is not closed"));
    EXPECT_THAT(refusal_of(""), HasSubstr("table.csv is empty"));
    EXPECT_THAT(refusal([] { read_csv("nowhere.csv"); }), HasSubstr("cannot be opened"));
    EXPECT_THAT(refusal([] { read_csv("."); }), HasSubstr("cannot be opened"));
}

TEST(CsvTable, TakesFiniteNumbersOnly) {
    for (const char* cell : {"nan", "NaN", "inf", "-inf"})
        EXPECT_THAT(refusal([&] { csv_number(cell, "f:2:"); }), HasSubstr("f:2: \"")) << cell;
    for (const char* cell : {"1.0x", "0x10", "1e999", "", "1 2", "--1"})
        EXPECT_NE(refusal([&] { csv_number(cell, "f:2:"); }), "nothing was refused") << cell;
}

TEST(CsvTable, TakesHeadingsApart) {
    EXPECT_EQ(csv_heading("radius [um]").name, "radius");
    EXPECT_EQ(csv_heading("radius [um]").unit, "um");
    EXPECT_EQ(csv_heading("cells").unit, "");
}

}  // namespace

}  // namespace crawford
