// `crawford points`: meshes of VTK as tables, and `judge` on them. The .vtu files were written by VTK 9.1.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>

#include "base/atomic_file.hpp"
#include "base/csv_table.hpp"
#include "base/source_tree.hpp"
#include "reference/truth_registry.hpp"
#include "tests/program/program.hpp"

namespace crawford {
namespace {

using testing::HasSubstr;

class Points : public ProgramTest {
protected:
    static std::string fixture(const std::string& name) {
        return source_path("tests/program/vtk/" + name + ".vtu").string();
    }
    static std::string content(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(stream), {}};
    }
    std::string written(const std::string& name, const std::string& text) const {
        write_file(out_ / name, text);
        return (out_ / name).string();
    }
};

TEST_F(Points, ReadsEveryFormOfTheSameMeshAlike) {
    const Finished points = crawford({"points", fixture("ascii")});
    ASSERT_EQ(points.status, 0) << points.output;
    EXPECT_THAT(points.output,
                testing::StartsWith(
                    "x [m],y [m],temperature [K],velocity_x,velocity_y,velocity_z,area [m2]\n"));
    EXPECT_THAT(points.output, HasSubstr("\n0.3333333333333333,0.3333333333333333,301,"));
    const Finished cells = crawford({"points", fixture("ascii"), "--at", "cells"});
    EXPECT_THAT(cells.output, HasSubstr("\"stress, whole_xx\""));
    for (const char* form : {"binary", "packed", "raw", "raw_packed", "base64", "base64_packed"}) {
        EXPECT_EQ(crawford({"points", fixture(form)}).output, points.output) << form;
        EXPECT_EQ(crawford({"points", fixture(form), "--at", "cells"}).output, cells.output)
            << form;
    }
}

TEST_F(Points, GivesEachPointItsShareOfTheArea) {
    const auto file = out_ / "points.csv";
    ASSERT_EQ(crawford({"points", fixture("ascii"), "--out", file.string()}).status, 0);
    const CsvTable table = read_csv(file);
    EXPECT_EQ(table.rows.size(), 16U);
    double area = 0.0;
    for (const CsvRow& row : table.rows) area += csv_number(row.cells.back(), "");
    EXPECT_NEAR(area, 1.0, 1e-14);
    const auto cells = out_ / "cells.csv";
    crawford({"points", fixture("ascii"), "--at", "cells", "--out", cells.string()});
    EXPECT_EQ(read_csv(cells).rows.size(), 18U) << "the line is no cell of the plane";
}

TEST_F(Points, RefusesWhatItCannotReadAndSaysWhatToDo) {
    expect_refused({"points", fixture("lz4")}, "write it with zlib or without compression");
    expect_refused({"points", (out_ / "none.vtu").string()}, "cannot read");
    const std::string ascii = content(fixture("ascii"));
    const auto altered = [&](const std::string& from, const std::string& to) {
        std::string text = ascii;
        text.replace(text.find(from), from.size(), to);
        return written("altered.vtu", text);
    };
    expect_refused({"points", altered("type=\"UnstructuredGrid\"", "type=\"ImageData\"")},
                   "UnstructuredGrid is read");
    expect_refused({"points", altered("</Points>", "")}, "it is no XML");
    expect_refused({"points", altered("0.3333", "0.3x33")}, "is no number");
    expect_refused({"points", altered("Name=\"types\"", "Name=\"tapes\"")}, "it has no types");
    expect_refused({"points", written("text.vtu", "x [m],y [m]\n0,0\n")}, "it is no XML");
}

TEST_F(Points, AnswersAnyDamageWithOneLine) {
    std::mt19937 random(14);
    for (const char* form : {"binary", "packed", "raw_packed", "base64"}) {
        const std::string whole = content(fixture(form));
        for (int k = 0; k < 12; ++k) {
            std::string text = whole;
            const size_t at = std::uniform_int_distribution<size_t>(0, text.size() - 1)(random);
            if (k % 2 == 0)
                text.resize(at);
            else
                text[at] = char(random());
            const Finished run = crawford({"points", written("damaged.vtu", text)});
            EXPECT_TRUE(run.status == 0 || run.status == 2) << form << ' ' << at << run.output;
            if (run.status == 2) {
                EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
            }
        }
    }
}

/// A row of quadrilaterals down a slab, with its exact temperature and an error of second order.
std::string slab_as_vtu(int grid, const std::string& name) {
    const auto truth = reference::truth("slab", {{"model", "thermal"}, {"depth", 300e-6}});
    std::string points, values, nodes, ends, types;
    for (int k = 0; k <= grid; ++k)
        for (const double x : {0.0, 1e-6}) {
            const double y = -300e-6 * k / grid;
            const auto exact =
                truth.values(std::vector<Eigen::Vector2d>{{x, y}}).column("temperature");
            points += fmt::format("{} {} 0\n", x, y);
            values += fmt::format("{} ", exact[0] + 100.0 / grid / grid * std::cos(1e4 * y));
        }
    for (int k = 0; k < grid; ++k) {
        nodes += fmt::format("{} {} {} {} ", 2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2);
        ends += fmt::format("{} ", 4 * (k + 1));
        types += "9 ";
    }
    const auto array = [](const std::string& heading, const std::string& text) {
        return "<DataArray " + heading + " format=\"ascii\">" + text + "</DataArray>";
    };
    return fmt::format(
        "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"{}\" "
        "NumberOfCells=\"{}\"><PointData>{}</PointData><Points>{}</Points><Cells>{}{}{}</Cells>"
        "</Piece></UnstructuredGrid></VTKFile>",
        2 * (grid + 1), grid, array("type=\"Float64\" Name=\"" + name + "\"", values),
        array("type=\"Float64\" NumberOfComponents=\"3\"", points),
        array("type=\"Int64\" Name=\"connectivity\"", nodes),
        array("type=\"Int64\" Name=\"offsets\"", ends),
        array("type=\"UInt8\" Name=\"types\"", types));
}

TEST_F(Points, AreJudgedWithTheirAreas) {
    std::vector<std::string> command{
        "judge",        "slab",    "--set",    "model=thermal", "--set",
        "depth=0.3 mm", "--field", "T=temp:K", "--json",        "-"};
    for (const int grid : {16, 32, 64})
        command.push_back(fmt::format(
            "{}={}", grid, written(fmt::format("{}.vtu", grid), slab_as_vtu(grid, "temp"))));
    const Finished run = crawford(command);
    ASSERT_EQ(run.status, 0) << run.output;
    const auto gate = nlohmann::json::parse(run.output).at("gates").at(0);
    EXPECT_NEAR(gate.at("fit").get<double>(), 2.0, 0.02);
    command.back() = "64=" + written("broken.vtu", "<VTKFile");
    expect_refused(command, "broken.vtu: it is no XML");
    command.back() = "64=" + fixture("lz4");
    expect_refused(command, "without compression");
}

TEST_F(Points, OfOurOwnSnapshotsCarryTheirUnits) {
    ASSERT_EQ(crawford({"burn", scenes + "sandwich.toml", "--set", "time.end=20 us", "--set",
                        "time.until_steady=", "--set", "domain.nx=8", "--set", "domain.ny=8",
                        "--set", "output.snapshots_every=20 us", "--out", out()})
                  .status,
              0);
    const Finished cells =
        crawford({"points", (out_ / "sandwich_000001.hdf").string(), "--at", "cells"});
    ASSERT_EQ(cells.status, 0) << cells.output;
    for (const char* heading : {"pressure [Pa]", "stress_xy [Pa]", "strain_yy [1]", "area [m2]"})
        EXPECT_THAT(cells.output, HasSubstr(heading));
    std::string damaged = content(out_ / "sandwich_000001.hdf");
    damaged.resize(damaged.size() / 2);
    expect_refused({"points", written("half.hdf", damaged)}, "half.hdf");
}

TEST_F(Points, OfASlabThatHasBurntAreJudgedFromItsSurface) {
    std::vector<std::string> command{"judge",  "slab",
                                     "--set",  "model=thermal",
                                     "--set",  "depth=480 um",
                                     "--set",  "heat_of_reaction=0 J/kg",
                                     "--json", "-"};
    for (const int rows : {32, 64, 128}) {
        const auto folder = out_ / std::to_string(rows);
        const Finished burnt = crawford(
            {"burn", scenes + "slab.toml", "--set", "physics.mechanics=false", "--set",
             "physics.reference_map=false", "--set", fmt::format("domain.ny={}", rows), "--set",
             "time.end=0.3 s", "--set", "output.snapshots_every=0.3 s", "--out", folder.string()});
        ASSERT_EQ(burnt.status, 0) << burnt.output;
        command.push_back(fmt::format("{}={}", rows, (folder / "slab_015000.hdf").string()));
    }
    expect_refused(command, "y must be from");
    command.emplace_back("--from-surface");
    const Finished run = crawford(command);
    ASSERT_EQ(run.status, 0) << run.output;
    const auto gate = nlohmann::json::parse(run.output).at("gates").at(0);
    EXPECT_EQ(gate.at("quantity"), "temperature");
    EXPECT_NEAR(gate.at("fit").get<double>(), 2.0, 0.05);
}

}  // namespace
}  // namespace crawford
