/// Figures in records: what is read back draws the same picture.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/atomic_file.hpp"
#include "base/scratch.hpp"
#include "reports/figure.hpp"
#include "reports/figure_json.hpp"
#include "reports/record_json.hpp"
#include "reports/record_store.hpp"

namespace crawford::reports {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class FigureRecords : public testing::Test {
protected:
    FigureRecords() {
        write_file(out_ / "script.gp",
                   "@panel_a\nplot data_line using 1:2 title sprintf('%.17g %s', third, word)\n"
                   "@panel_b\nset multiplot\n@map_only\n@colours_sheet\n"
                   "splot data_sheet using 1:2:3 with pm3d\nunset multiplot\n");
    }

    Figure figure() const {
        Figure figure("one", out_, out_ / "script.gp");
        figure.table("line", {{"x", "um", {0, 1, 2}}, {"T", "K", {300, 301, 305}}})
            .map("sheet", {2,
                           1,
                           {"x", "um", {0, 1, 2, 0, 1, 2}},
                           {"y", "um", {0, 0, 0, 1, 1, 1}},
                           {{"p", "MPa", {1, 2}}}})
            .set("third", 1.0 / 3.0)
            .set("nothing", std::nan(""))
            .set("word", "it's")
            .caption({.grid = "2 × 1"})
            .panel("a")
            .panel("b", Format::png, {.width = 300, .height = 200});
        return figure;
    }

    const Scratch scratch_;
    const fs::path out_ = scratch_.path();
};

Record record_of(const Figure& figure) {
    Record record{.experiment = "one", .setting = {}, .found = Measurement()};
    record.found->value("z", Amount{0.1, "K"}).value("a", Amount{std::nan(""), "-"});
    record.scenes = {"title = \"\"\n"};
    record.figure = figure.contents();
    return record;
}

TEST_F(FigureRecords, KeepFilesForOtherPrograms) {
    Figure drawn = figure();
    drawn.other("json", "../one.json", "{}");
    EXPECT_EQ(content(out_ / "one.json"), "{}");
    drawn.draw();  // the script knows nothing of it
    const auto read = nlohmann::ordered_json(drawn.contents()).get<FigureContents>();
    EXPECT_EQ(read.tables, drawn.contents().tables);
    EXPECT_EQ(read.data().back(), "../one.json");
}

TEST_F(FigureRecords, DrawTheSameBytes) {
    const Figure drawn = figure();
    const auto pictures = drawn.draw();
    std::vector<std::string> before;
    for (const auto& picture : pictures) {
        before.push_back(content(picture));
        fs::remove(picture);
    }
    RecordStore(out_ / "records", "f").add(record_of(drawn));

    const auto record = RecordStore(out_ / "records", "other").newest("one");
    ASSERT_TRUE(record && record->figure);
    const auto again = draw(*record->figure, out_ / "figures");
    ASSERT_EQ(again, pictures);
    for (size_t k = 0; k < pictures.size(); ++k) EXPECT_EQ(content(again[k]), before[k]);
}

TEST_F(FigureRecords, KeepNumbersWithUnitsInTheirOrder) {
    const nlohmann::ordered_json json = record_of(figure());
    EXPECT_EQ(json.at("quantities").at(0).at("unit"), "K");
    EXPECT_FALSE(json.contains("h")) << "no order is read from it";
    const auto record = json.get<Record>();
    ASSERT_EQ(record.found->values().size(), 2U);
    EXPECT_EQ(record.found->values()[0].first, "z");
    EXPECT_EQ(record.found->values()[0].second, (Amount{0.1, "K"}));
    EXPECT_TRUE(std::isnan(record.found->values()[1].second.value));
    EXPECT_EQ(record.scenes.size(), 1U);
}

TEST_F(FigureRecords, SayWhichTablesAreGone) {
    Figure movie("one", out_, out_ / "script.gp");
    movie.forget_numbers().table("line", {{"x", "um", {0, 1}}});
    const nlohmann::ordered_json json = movie.contents();
    const auto contents = json.get<FigureContents>();
    EXPECT_FALSE(contents.keeps_numbers);
    EXPECT_TRUE(contents.tables.empty());
}

TEST_F(FigureRecords, AreForgottenWhole) {
    RecordStore store(out_ / "records", "f");
    store.add(record_of(figure()));
    store.forget("one");
    EXPECT_FALSE(store.newest("one"));
    EXPECT_FALSE(RecordStore(out_ / "records", "f").newest("one"));
}

}  // namespace
}  // namespace crawford::reports
