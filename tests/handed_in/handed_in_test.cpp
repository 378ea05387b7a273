// Our own solver's fields through files: `crawford judge` tells of them what `crawford verify` tells of the study
// that burnt the same slabs, digit for digit.
#include <fmt/format.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/units.hpp"
#include "tests/program/program.hpp"

namespace crawford {
namespace {

using Json = nlohmann::json;
using namespace units;

const std::vector<int> grids{32, 64, 128};

class HandedIn : public ProgramTest {
protected:
    std::string written(const std::string& name, const std::string& heading,
                        const std::vector<std::vector<double>>& columns) const {
        std::string text = heading + '\n';
        for (size_t k = 0; k < columns.front().size(); ++k) {
            text += '0';
            for (const auto& column : columns) text += fmt::format(",{}", column.at(k));
            text += '\n';
        }
        write_file(out_ / name, text);
        return (out_ / name).string();
    }

    using Gates = std::map<std::string, Json>;  ///< by quantity and norm

    static void add(Gates& gates, const Json& list) {
        for (const Json& gate : list)
            gates[gate.at("quantity").get<std::string>() + ", " + gate.value("norm", "")] = gate;
    }

    Gates verified() const {
        const std::string study = "slab, AP, beta = 3 alpha K";
        const Finished run = crawford({"verify", study, "--grids", "32,64,128", "--out", out()});
        std::ifstream file(out_ / "verify.json");
        Gates gates;
        add(gates, Json::parse(file).at("gates"));
        EXPECT_FALSE(gates.empty()) << run.output;
        return gates;
    }

    static Gates judged(const std::vector<std::string>& files) {
        std::vector<std::string> command{"judge",    "slab",
                                         "--set",    "depth=1200 um",
                                         "--set",    "heat_of_reaction=0 J/kg",
                                         "--expect", "2",
                                         "--json",   "-"};
        command.insert(command.end(), files.begin(), files.end());
        const Finished run = crawford(command);
        const Json json = Json::parse(run.output);
        Gates gates;
        for (const char* list : {"gates", "not_gated"}) add(gates, json.at(list));
        return gates;
    }
};

void expect_same(const Json& ours, const Json& through_files) {
    for (const char* member : {"errors", "pairwise_orders"}) {
        const auto a = ours.at(member).get<std::vector<double>>();
        const auto b = through_files.at(member).get<std::vector<double>>();
        ASSERT_EQ(a.size(), b.size()) << ours;
        // The weights are summed in the file's order, so the last bit may differ.
        for (size_t k = 0; k < a.size(); ++k)
            EXPECT_NEAR(b[k], a[k], 1e-12 * std::abs(a[k])) << member << ' ' << ours;
    }
    EXPECT_EQ(ours.at("grids"), through_files.at("grids"));
}

TEST_F(HandedIn, TellsOfOurFieldsWhatVerifyTells) {
    std::vector<std::string> nodes, cells;
    for (const int grid : grids) {
        const SlabProfile run =
            burn_to_steady(slab("AP", {.cells = grid, .clustering = 2.0, .depth = 1200.0 * um})
                               .regressing(0.45 * cm / s)
                               .heated(200.0 * cal / (s * cm2))
                               .pressed(2.0 * MPa)
                               .scene());
        nodes.push_back(
            fmt::format("{}={}", grid,
                        written(fmt::format("nodes{}.csv", grid),
                                "x [m],y [m],temperature [K],velocity_y [m/s],weight",
                                {run.node_y, run.temperature, run.velocity, run.node_weight})));
        cells.push_back(
            fmt::format("{}={}", grid,
                        written(fmt::format("cells{}.csv", grid),
                                "x [m],y [m],deformation_gradient_yy [1],weight",
                                {run.cell_y, run.deformation_gradient_22, run.cell_weight})));
    }
    auto ours = verified();
    auto at_nodes = judged(nodes), at_cells = judged(cells);
    expect_same(ours.at("T, L2"), at_nodes.at("temperature, L2"));
    expect_same(ours.at("T, Linf"), at_nodes.at("temperature, Linf"));
    expect_same(ours.at("v, L2"), at_nodes.at("velocity_y, L2"));
    expect_same(ours.at("F_22, L2"), at_cells.at("deformation_gradient_yy, L2"));
}

}  // namespace
}  // namespace crawford
