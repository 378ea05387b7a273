/// `crawford judge`: another code's fields held against an exact solution.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "reference/truth_registry.hpp"
#include "reports/measurement.hpp"
#include "reports/order.hpp"
#include "tests/program/program.hpp"

namespace crawford {
namespace {

using testing::HasSubstr;

constexpr double depth = 300e-6;

class Judge : public ProgramTest {
protected:
    /// Temperature of the slab in deg C at depths, with an error of its own.
    std::string results(int grid, const std::function<double(double h, double y)>& error,
                        const std::string& header = "x [mm],y [um],temp\n") const {
        std::string text = header;
        const auto truth = reference::truth("slab", {{"model", "thermal"}, {"depth", depth}});
        for (int k = 0; k <= grid; ++k) {
            const double y = -300.0 * k / grid;
            const auto exact =
                truth.values(std::vector<Eigen::Vector2d>{{0.0, y * 1e-6}}).column("temperature");
            text += fmt::format("0,{},{}\n", y, exact[0] - 273.15 + error(1.0 / grid, y));
        }
        const auto file = out_ / fmt::format("T{}.csv", grid);
        write_file(file, text);
        return fmt::format("{}={}", grid, file.string());
    }

    std::vector<std::string> judged(const std::function<double(double h, double y)>& error,
                                    const std::vector<std::string>& more = {}) const {
        std::vector<std::string> command{"judge", "slab",         "--set",   "model=thermal",
                                         "--set", "depth=0.3 mm", "--field", "T=temp:degC"};
        for (const int grid : {64, 16, 32}) command.push_back(results(grid, error));
        command.insert(command.end(), more.begin(), more.end());
        return command;
    }
};

double of_order(double p, double h, double y) {
    return 100.0 * std::pow(h, p) * std::cos(y / 100.0);
}
double second(double h, double y) {
    return of_order(2.0, h, y);
}
double first(double h, double y) {
    return of_order(1.0, h, y);
}

TEST_F(Judge, PassesACodeOfSecondOrderAndCatchesOneOfFirst) {
    const Finished right = crawford(judged(second));
    EXPECT_EQ(right.status, 0) << right.output;
    EXPECT_THAT(right.output, HasSubstr("temperature, L2: order 2 +- 0.1, grids 16 to 64"));
    const Finished wrong = crawford(judged(first));
    EXPECT_EQ(wrong.status, 1) << wrong.output;
    EXPECT_THAT(wrong.output, HasSubstr("is outside [1.9, 2.1]"));
    EXPECT_EQ(crawford(judged(first, {"--expect", "1"})).status, 0);
}

TEST_F(Judge, TellsTheVerdictOfOurOwnEngineToTheLastDigit) {
    const Finished run = crawford(judged(second, {"--json", "-"}));
    ASSERT_EQ(run.status, 0) << run.output;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_EQ(json.at("passed"), true);
    const auto& gate = json.at("gates").at(0);
    EXPECT_EQ(gate.at("quantity"), "temperature");
    EXPECT_EQ(gate.at("norm"), "L2");
    const auto h = gate.at("h").get<std::vector<double>>();
    const auto errors = gate.at("errors").get<std::vector<double>>();
    std::vector<reports::Level> levels;
    for (std::size_t k = 0; k < h.size(); ++k)
        levels.push_back({gate.at("grids").at(k).get<int>(), h[k], errors[k]});
    const reports::Convergence ours(levels);
    EXPECT_EQ(gate.at("fit"), ours.fit());
    EXPECT_EQ(gate.at("pairwise_orders").get<std::vector<double>>(), ours.pairwise());
    double squares = 0.0;
    for (int k = 0; k <= 64; ++k) squares += std::pow(second(1.0 / 64.0, -300.0 * k / 64.0), 2);
    EXPECT_NEAR(errors.back(), std::sqrt(squares / 65.0), 1e-9);
}

TEST_F(Judge, WeighsThePoints) {
    // The last point is wrong by 1 K and stands for nearly nothing.
    const auto truth = reference::truth("slab");
    const auto at = [&](double y) {
        return truth.values(std::vector<Eigen::Vector2d>{{0.0, y}}).column("temperature")[0];
    };
    write_file(out_ / "a.csv",
               fmt::format("x [m],y [m],temperature [K],area [m2]\n0,0,{},1\n0,-1e-5,{},1e-12\n",
                           at(0.0), at(-1e-5) + 1.0));
    const Finished run =
        crawford({"judge", "slab", "8=" + (out_ / "a.csv").string(), "--json", "-"});
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_NEAR(json.at("gates").at(0).at("errors").at(0), 1e-6, 1e-9);
    EXPECT_EQ(run.status, 1) << "one grid shows no order";
}

TEST_F(Judge, NeverPassesTheTraps) {
    EXPECT_THAT(crawford(judged([](double, double) { return 1.0; })).output,
                HasSubstr("the same error"));
    EXPECT_THAT(crawford(judged([](double, double) { return 0.0; })).output,
                HasSubstr("round-off"));
    EXPECT_EQ(crawford(judged([](double, double) { return 0.0; })).status, 1);
    EXPECT_EQ(crawford(judged([](double h, double y) { return of_order(4.0, h, y); })).status, 1);
    expect_refused(judged([](double, double y) { return y < -290.0 ? std::nan("") : 0.0; }),
                   "is no finite number");
}

TEST_F(Judge, SaysWhatToSolve) {
    const Finished text = crawford({"judge", "slab", "--describe"});
    EXPECT_EQ(text.status, 0);
    for (const char* word : {"what to solve", "density", "AP 1950, binder 920", "Gates",
                             "temperature, L2: order 2", "Fields:"})
        EXPECT_THAT(text.output, HasSubstr(word));
    for (const auto& command : {std::vector<std::string>{"judge", "slab", "--describe", "--json"},
                                {"judge", "slab", "--describe", "--json", "-"}}) {
        const Finished run = crawford(command);
        EXPECT_EQ(run.status, 0) << run.output;
        const auto json = nlohmann::json::parse(run.output);
        EXPECT_EQ(json.at("truth"), "slab");
        EXPECT_EQ(json.at("gates").at(0).at("field"), "temperature");
    }
    for (const auto& entry : reference::truths())
        EXPECT_EQ(crawford({"judge", entry.name, "--describe"}).status, 0) << entry.name;
}

TEST_F(Judge, WritesAPageAndFiles) {
    const std::string page = (out_ / "page").string();
    const Finished run =
        crawford(judged(first, {"--out", page, "--junit", (out_ / "j.xml").string(), "--json",
                                (out_ / "j.json").string()}));
    EXPECT_EQ(run.status, 1) << run.output;
    const auto content = [](const std::filesystem::path& file) {
        std::ifstream stream(file);
        return std::string{std::istreambuf_iterator<char>(stream), {}};
    };
    EXPECT_THAT(content(out_ / "page/report.html"), HasSubstr("results of another code"));
    EXPECT_THAT(content(out_ / "page/report.html"), testing::Not(HasSubstr("Coverage")));
    EXPECT_THAT(content(out_ / "page/verify.json"), HasSubstr("\"slab\""));
    EXPECT_THAT(content(out_ / "j.xml"), HasSubstr("failures=\"2\""));
    EXPECT_EQ(nlohmann::json::parse(content(out_ / "j.json")).at("passed"), false);
}

TEST_F(Judge, RefusesWhatIsWrongAndNamesIt) {
    const auto zero = [](double, double) { return 0.0; };
    const auto file = results(16, zero);
    const auto refused = [&](std::vector<std::string> arguments, const std::string& message) {
        arguments.insert(arguments.begin(), "judge");
        expect_refused(arguments, message);
    };
    refused({}, "CASE is required");
    refused({"slap", file}, "no case is called slap; did you mean slab?");
    refused({"slab"}, "no GRID=FILE is given");
    refused({"slab", "T16.csv"}, "write GRID=FILE");
    refused({"slab", "16x=T16.csv"}, "write GRID=FILE");
    refused({"slab", file}, "has no field of slab; map one with --field");
    refused({"slab", file, "--field", "temp"}, "write NAME=COLUMN");
    refused({"slab", file, "--field", "TT=temp"}, "slab has no field TT");
    refused({"slab", file, "--field", "T=tmp"}, "no column \"tmp\"; did you mean temp?");
    refused({"slab", file, "--field", "T=temp"}, "the column \"temp\" has no unit");
    refused({"slab", file, "--field", "T=temp:m"}, "wrong dimension");
    refused({"slab", file, "--field", "T=temp:K", "--field", "temperature=temp:K"},
            "temperature is given twice");
    refused({"slab", file, file, "--field", "T=temp:K"}, "grid 16 is given twice");
    refused({"slab", file, "--field", "T=temp:degC", "--set", "depth=0.2 mm"}, "T16.csv:13: point");
    refused({"slab", file, "--field", "T=temp:degC", "--set", "dept=0.2 mm"}, "did you mean depth");
    refused({"slab", "--field", "T=temp:K", "--json", file}, "before the next argument");
}

}  // namespace
}  // namespace crawford
