#include "reports/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/process.hpp"
#include "base/scratch.hpp"
#include "reports/convergence_figure.hpp"

namespace crawford::reports {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A directory of the test's own, with a quote and a space in its name to trip careless quoting.
class Figures : public testing::Test {
protected:
    Figures() { fs::create_directories(out_); }

    fs::path script(const std::string& text) const {
        write_file(out_ / "script.gp", text);
        return out_ / "script.gp";
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(out_ / "figures"), fs::directory_iterator{}));
    }

    const Scratch scratch_;
    const fs::path out_ = scratch_.path() / "it's `false` here";
    std::vector<Column> line_{{"depth", "um", {0.0, 1.0, 2.0}},
                              {"temperature", "K", {300.0, 0.1, std::nan("")}}};
};

TEST_F(Figures, WriteTheirNumbersBesideThem) {
    const auto s =
        script("@panel\nplot data_solver using 1:2 title sprintf('%.1f %s', height, label)\n");
    const auto drawn = Figure("fig03", out_, s)
                           .table("solver", line_)
                           .set("height", 2.5)
                           .set("label", "it's")
                           .caption({.grid = "1 x 128", .step = "20 us", .revision = "abc_1"})
                           .draw();
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0], out_ / "figures" / "fig03.svg");
    EXPECT_EQ(contents(out_ / "figures" / "fig03_solver.csv"),
              "depth [um],temperature [K]\n0,300\n1,0.1\n2,nan\n");
    const auto svg = contents(drawn[0]);
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << "complete";
    EXPECT_NE(svg.find("grid 1 x 128  |  step 20 us  |  revision abc_1"), std::string::npos);
    EXPECT_NE(svg.find("2.5 it"), std::string::npos);
    EXPECT_EQ(files(), 2U) << "nothing temporary is left";
}

TEST_F(Figures, DrawPanelsOfBothFormats) {
    QuadMap quads{2,
                  1,
                  {"x", "um", {0, 1, 2, 0, 1, 2}},
                  {"y", "um", {0, 0.1, 0, 1, 1.1, 1}},
                  {{"T", "K", {1, 2}}}};
    const auto s = script(
        "@panel_a\nplot data_solver using 1:2\n"
        "@panel_b\neval map_place(0.2, 0.8, 0.2, 0.9)\nset xrange [0:2]\nset yrange [0:1.1]\n"
        "set multiplot\n@map_only\neval diverging(-0.1, 2)\n@colours_T\n"
        "splot data_T using 1:2:3 with pm3d\n@map_frame\neval heading('b', 'T')\n"
        "plot data_T using 1:2 with lines\nunset multiplot\n");
    const auto drawn = Figure("fig03", out_, s)
                           .table("solver", line_)
                           .map("T", quads)
                           .panel("a")
                           .panel("b", Format::png)
                           .draw();
    ASSERT_EQ(drawn.size(), 2U);
    EXPECT_EQ(drawn[0].filename(), "fig03a.svg");
    EXPECT_EQ(drawn[1].filename(), "fig03b.png");
    EXPECT_EQ(contents(drawn[1]).substr(1, 3), "PNG");
}

TEST_F(Figures, WithOnePanelHaveNoLetter) {
    const auto s = script("@panel\nplot data_solver using 1:2\n");
    const auto drawn = Figure("table1", out_, s)
                           .table("solver", line_)
                           .panel(Format::svg, {.width = 820, .height = 560})
                           .draw();
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0].filename(), "table1.svg");
    EXPECT_NE(contents(drawn[0]).find("viewBox=\"0 0 820 560\""), std::string::npos);
}

TEST_F(Figures, CanBeMoviesThatKeepNoNumbers) {
    const auto s = script("@panel\ndo for [k = 1:3] { plot data_solver using 1:(k * $2) }\n");
    {
        Figure movie("fig13", out_, s);
        movie.forget_numbers().table("solver", line_);
        movie.panel(Format::gif, {.width = 200, .height = 100});
        EXPECT_TRUE(movie.contents().data().empty());
        const auto drawn = movie.draw();
        ASSERT_EQ(drawn.size(), 1U);
        EXPECT_EQ(drawn[0].filename(), "fig13.gif");
        const auto gif = contents(drawn[0]);
        EXPECT_EQ(gif.substr(0, 6), "GIF89a");
        const std::string frame = {'\x21', '\xf9', '\x04'};
        int frames = 0;
        for (auto at = gif.find(frame); at != std::string::npos; at = gif.find(frame, at + 1))
            ++frames;
        EXPECT_EQ(frames, 3);
    }
    EXPECT_EQ(files(), 1U) << "the movie and no numbers";
}

TEST_F(Figures, RefusePanelsThatWouldShareAName) {
    Figure one("fig", out_, "x.gp");
    one.panel(Format::png);
    EXPECT_THROW(one.panel("a"), std::invalid_argument);
    EXPECT_THROW(one.panel(Format::png), std::invalid_argument);
    Figure two("fig", out_, "x.gp");
    two.panel("a");
    EXPECT_THROW(two.panel("a", Format::png), std::invalid_argument);
    EXPECT_THROW(two.panel(Format::svg), std::invalid_argument);
    EXPECT_NO_THROW(two.panel("b"));
}

TEST_F(Figures, ThatFailSayWhyAndLeaveTheOldOneAlone) {
    write_file(out_ / "figures" / "fig03.svg", "old");
    const auto message = [&](const std::string& text) -> std::string {
        try {
            Figure("fig03", out_, script(text)).table("solver", line_).draw();
        } catch (const FigureFailed& failure) {
            return failure.what();
        }
        return "drawn";
    };
    EXPECT_NE(message("@panel\nplot nonsense(x)\n").find("undefined function: nonsense"),
              std::string::npos);
    EXPECT_NE(message("x = 1\n").find("no picture fig03.svg"), std::string::npos);
    EXPECT_NE(message("@panel\nplot x, data_solver using 1:7\n").find("no valid points"),
              std::string::npos);
    EXPECT_NE(message("@panel\nplot x, 'missing.csv'\n").find("missing.csv"), std::string::npos);
    EXPECT_EQ(contents(out_ / "figures" / "fig03.svg"), "old");
    EXPECT_EQ(files(), 2U) << "nothing temporary is left";
}

TEST_F(Figures, RefuseNamesThatCouldBeMoreThanNames) {
    EXPECT_THROW(Figure("../fig", out_, "x.gp"), std::invalid_argument);
    Figure figure("fig", out_, "x.gp");
    EXPECT_THROW(figure.set("a = system('true') #", 1.0), std::invalid_argument);
    EXPECT_THROW(figure.set("a", "two\nlines"), std::invalid_argument);
    EXPECT_THROW(figure.table("a b", line_), std::invalid_argument);
    EXPECT_THROW(figure.panel(""), std::invalid_argument);
}

TEST_F(Figures, DrawConvergence) {
    std::vector<Level> levels;
    for (const int n : {32, 64, 128, 256}) levels.push_back({n, 1.0 / n, 5e6 / n / n});
    const auto drawn =
        draw_convergence("orders", out_, "slab, AP", {{"T_s, L2", Convergence(levels, 1e6), 2.0}},
                         {.revision = "abc"});
    const auto svg = contents(drawn);
    EXPECT_NE(svg.find("order 2"), std::string::npos);
    EXPECT_NE(svg.find("T_s, L2"), std::string::npos) << "no subscripts made of underscores";
    EXPECT_NE(contents(out_ / "figures" / "orders_curve_1.csv").find("0.03125,0.0048828125"),
              std::string::npos)
        << "5e6/32^2 over 1e6";
    EXPECT_THROW(draw_convergence("none", out_, "",
                                  {{"x", Convergence({{32, 0.1, std::nan("")}}), 2.0}}, {}),
                 std::invalid_argument);
}

TEST(Csv, RefusesWhatIsNoTable) {
    EXPECT_THROW(csv(std::vector<Column>{}), std::invalid_argument);
    EXPECT_THROW(csv({{"a", "m", {1, 2}}, {"b", "m", {1}}}), std::invalid_argument);
    EXPECT_THROW(csv({{"a,b", "m", {1}}}), std::invalid_argument);
}

TEST(Csv, KeepsEveryDigit) {
    const double third = 1.0 / 3.0;
    const auto text = csv({{"a", "-", {third}}});
    EXPECT_EQ(std::stod(text.substr(text.find('\n'))), third);
}

TEST(QuadCsv, SeparatesScanLinesAndRepeatsCellsAtTheRim) {
    const QuadMap cells{
        1, 1, {"x", "m", {0, 1, 0, 1}}, {"y", "m", {0, 0, 1, 1}}, {{"p", "Pa", {7}}}};
    EXPECT_TRUE(cells.at_cells());
    EXPECT_EQ(csv(cells), "x [m],y [m],p [Pa]\n0,0,7\n1,0,7\n\n0,1,7\n1,1,7\n\n");
    auto corners = cells;
    corners.fields[0].values = {1, 2, 3, 4};
    EXPECT_FALSE(corners.at_cells());
    EXPECT_EQ(csv(corners), "x [m],y [m],p [Pa]\n0,0,1\n1,0,2\n\n0,1,3\n1,1,4\n\n");
    corners.fields[0].values = {1, 2};
    EXPECT_THROW(csv(corners), std::invalid_argument);
}

TEST(RunProgram, PassesArgumentsAsTheyAre) {
    const auto echoed = run_program({"printf", "%s", "$HOME `id` ; 'x'"});
    EXPECT_EQ(echoed.status, 0);
    EXPECT_EQ(echoed.output, "$HOME `id` ; 'x'");
    EXPECT_EQ(run_program({"false"}).status, 1);
    EXPECT_THROW(run_program({"no-such-program-anywhere"}), std::system_error);
}

TEST(AtomicFiles, AppearCompleteOrNotAtAll) {
    const Scratch scratch;
    const auto target = scratch.path() / "deep" / "file.txt";
    {
        AtomicFile unfinished(target);
        std::ofstream(unfinished.temporary()) << "half";
        EXPECT_TRUE(fs::exists(unfinished.temporary()));
    }
    EXPECT_TRUE(fs::is_empty(target.parent_path()));
    write_file(target, "whole");
    EXPECT_EQ(contents(target), "whole");
    EXPECT_THROW(write_file(target / "below a file", "x"), InputError);
    EXPECT_THROW(AtomicFile(target).commit(), InputError) << "nothing was written";
    EXPECT_EQ(contents(target), "whole");
}

}  // namespace
}  // namespace crawford::reports
