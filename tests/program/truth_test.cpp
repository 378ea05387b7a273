/// `crawford truth`: the exact solutions, as somebody else's program asks for them.
#include <cmath>
#include <sstream>

#include "base/atomic_file.hpp"
#include "base/csv_table.hpp"
#include "reference/truth_registry.hpp"
#include "tests/program/program.hpp"

namespace crawford {
namespace {

using testing::HasSubstr;

class TruthCommand : public ProgramTest {
protected:
    std::string points(const std::string& text) const {
        write_file(out_ / "points.csv", text);
        return (out_ / "points.csv").string();
    }
    CsvTable told(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "truth");
        const Finished run = crawford(arguments);
        EXPECT_EQ(run.status, 0) << run.output;
        write_file(out_ / "told.csv", run.output);
        return read_csv(out_ / "told.csv");
    }
    static double cell(const CsvTable& table, std::size_t row, const std::string& heading) {
        const auto at = std::ranges::find(table.header, heading) - table.header.begin();
        return csv_number(table.rows.at(row).cells.at(static_cast<std::size_t>(at)), "");
    }
};

TEST_F(TruthCommand, TellsWhatTheRegistryTellsToTheLastDigit) {
    const auto file = points("y [um],x [mm]\n0,0\n-20,0.01\n");
    const CsvTable table = told({"slab", "--points", file, "--set", "material=binder", "--set",
                                 "cold_temperature=20 degC", "--set", "heat_flux=100 cal/(s cm2)"});
    const auto truth = reference::truth(
        "slab", {{"material", "binder"}, {"cold_temperature", 293.15}, {"heat_flux", 4.184e6}});
    const auto values = truth.values(std::vector<Eigen::Vector2d>{{0.0, 0.0}, {1e-5, -2e-5}});
    ASSERT_EQ(table.rows.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(cell(table, k, "temperature [K]"), values.column("temperature")[k]);
        EXPECT_EQ(cell(table, k, "stress_xx [Pa]"), values.column("stress_xx")[k]);
    }
    EXPECT_EQ(cell(table, 1, "y [m]"), -2e-5);
}

TEST_F(TruthCommand, KnowsEveryTruthOfTheRegistry) {
    const std::string list = crawford({"truth", "--list"}).output;
    EXPECT_EQ(std::ranges::count(list, '\n'), static_cast<long>(reference::truths().size()));
    for (const auto& entry : reference::truths()) {
        EXPECT_THAT(list, HasSubstr(entry.name + ' '));
        const std::string help = crawford({"truth", entry.name, "--help"}).output;
        EXPECT_EQ(help, crawford({"truth", entry.name, "--describe"}).output);
        for (const auto& parameter : entry.parameters)
            EXPECT_THAT(help, HasSubstr("  " + parameter.name)) << entry.name;
        for (const auto& field : entry.fields)
            EXPECT_THAT(help, HasSubstr(field.name + " [" + field.unit + "]")) << entry.name;
    }
}

TEST_F(TruthCommand, TakesEveryParameterWithItsUnit) {
    for (const auto& entry : reference::truths()) {
        std::vector<std::string> command{"truth", entry.name, "--describe"};
        for (const auto& parameter : entry.parameters) {
            if (!parameter.standard || parameter.is_text()) continue;
            const double value = std::get<double>(*parameter.standard);
            if (!std::isfinite(value)) continue;
            // Every unit is one that a user can type.
            const Finished run = crawford({"truth", entry.name, "--set",
                                           parameter.name + "=nonsense " + parameter.unit,
                                           "--points", points("x [m],y [m]\n0,0\n")});
            EXPECT_EQ(run.status, 2) << run.output;
            EXPECT_THAT(run.output, HasSubstr(parameter.name)) << run.output;
        }
    }
}

TEST_F(TruthCommand, RefusesWhatIsWrongAndNamesIt) {
    const auto origin = points("x [m],y [m]\n0,0\n");
    const auto refused = [&](std::vector<std::string> arguments, const std::string& message) {
        arguments.insert(arguments.begin(), "truth");
        expect_refused(arguments, message);
    };
    refused({}, "no truth is named; crawford truth --list");
    refused({"slap", "--points", origin}, "unknown truth slap; did you mean slab?");
    refused({"slab"}, "--points FILE.csv is missing");
    refused({"slab", "--points", origin, "--set", "dept=1 m"}, "did you mean depth?");
    refused({"slab", "--points", origin, "--set", "depth"}, "write key=value");
    refused({"slab", "--points", origin, "--set", "depth=3"}, "slab: depth = \"3\" has no unit");
    refused({"slab", "--points", origin, "--set", "depth=3 K"}, "wrong dimension");
    refused({"slab", "--points", origin, "--set", "depth=-3 m"}, "depth = -3 m must be above 0 m");
    refused({"slab", "--points", origin, "--set", "depth=nan"}, "slab: depth = nan m must be");
    refused({"slab", "--points", origin, "--set", "material=gold"}, "gold is unknown");
    refused({"manufactured-heat", "--points", origin, "--time", "2"}, "--time \"2\" has no unit");
    refused({"slab", "--points", points("x [m],y [m]\n0,0\n0,1\n")},
            "points.csv:3: point (0, 1) m: y must be");
    refused({"slab", "--points", points("x,y\n0,0\n")}, "the column \"x\" has no unit");
    refused({"slab", "--points", points("x [m],y [K]\n0,0\n")}, "wrong dimension");
    refused({"slab", "--points", points("x [m]\n0\n")}, "has no column \"y\"");
    refused({"slab", "--points", points("x [m],y [m],z [m]\n0,0,0\n")}, "the column \"z [m]\"");
    refused({"slab", "--points", points("x [m],y [m]\n")}, "holds no points");
    refused({"slab", "--points", "nowhere.csv"}, "cannot be opened");
}

TEST_F(TruthCommand, KnowsTheTime) {
    const auto file = points("x [m],y [m]\n2e-5,-5e-5\n");
    const auto at = [&](const std::string& time) {
        return cell(told({"manufactured-burning", "--points", file, "--time", time}), 0,
                    "temperature [K]");
    };
    const auto truth = reference::truth("manufactured-burning");
    const std::vector<Eigen::Vector2d> point{{2e-5, -5e-5}};
    EXPECT_EQ(at("2 ms"), truth.values(point, 2e-3).column("temperature")[0]);
    EXPECT_NE(at("2 ms"), at("0 s"));
}

}  // namespace
}  // namespace crawford
