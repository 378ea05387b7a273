/// `crawford order`: anyone's table held against an order, as its user meets it.
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "reports/default_estimate.hpp"
#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Order : public ProgramTest {
protected:
    std::string table(const std::string& text) const {
        write_file(out_ / "table.csv", text);
        return (out_ / "table.csv").string();
    }
    std::string file(const char* name) const { return (out_ / name).string(); }
    std::string content(const char* name) const {
        std::ifstream stream(out_ / name);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    Finished gated(const std::string& text) const {
        return crawford({"order", table(text), "--expect", "2", "--within", "0.1"});
    }
    void expect_failure(const std::string& text, const std::string& reason) const {
        const Finished run = gated(text);
        EXPECT_EQ(run.status, 1) << run.output;
        EXPECT_THAT(run.output, HasSubstr(reason));
    }
};

constexpr auto second = "cells,error_T\n64,1e-4\n16,1.6e-3\n32,4e-4\n";
constexpr auto first = "cells,error_T\n16,1.6e-3\n32,8e-4\n64,4e-4\n";

TEST_F(Order, PassesWhatConvergesAsExpected) {
    const Finished run = gated(second);
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("fit 2.000, monotone; expected 2 within 0.1: pass"));
}

TEST_F(Order, CatchesAFirstOrderCode) {
    expect_failure(first, "order 1.000 is outside [1.9, 2.1]");
    EXPECT_EQ(crawford({"order", table(first)}).status, 0) << "nothing is expected";
}

TEST_F(Order, FailsTheTrapsThatOthersFallInto) {
    expect_failure("h,error\n4,1e-3\n2,1e-3\n1,1e-3\n", "the same error");
    expect_failure("h,error\n4,4e-16\n2,1e-16\n1,2.5e-17\n", "round-off");
    expect_failure("h,error\n2,4\n1,1\n", "2 of at least 3 grids");
    expect_failure("h,error\n4,256\n2,16\n1,1\n", "order 4.000 is outside");
    expect_failure("h,error\n8,64\n4,1\n2,4\n1,0.5\n", "oscillating");
    expect_failure("h,error\n4,1\n2,4\n1,16\n", "diverging");
    expect_failure("h,error\n4,16\n2,-4\n1,1\n", "negative");
    expect_failure("h,u\n4,1\n2,1\n1,1\n", "round-off");
    expect_failure("h,u\n4,1.0\n2,1.4\n1,1.3\n", "oscillating");
}

TEST_F(Order, RefusesWhatIsNoTable) {
    const auto refused = [&](const std::string& text, const std::string& message) {
        expect_refused({"order", table(text), "--expect", "2"}, message);
    };
    refused("h,error\n4,16\n2,nan\n1,1\n", "table.csv:3: \"nan\" is no finite number");
    refused("h,error\n4,16\n2,\n1,1\n", ":3: the cell of column \"error\" is empty");
    refused("h,error\n4,16\n2,4x\n1,1\n", ":3: \"4x\" is no number");
    refused("h;error\n4;16\n", ":1: has semicolons");
    refused("h,error\n4,16\n2,4\n4,16\n1,1\n", ":4: h = 4 stands in line 2, too");
    refused("h,error\n4,16\n0,4\n", ":3: h = 0 must be above 0");
    refused("h,error\n4,16\n2,4,1\n", ":3: has 3 values; expected 2");
    refused("# nothing\n", "is empty");
    refused("h,error\n", "has 0 grids");
    refused("h,error\n1,1\n", "has 1 grid;");
    refused("N,error\n1,1\n", "the first column is \"N\"; it must be h, h [unit] or cells");
    refused("h\n1\n2\n", "there is only \"h\"");
    refused("h,e,e\n1,1,1\n", "twice");
    expect_refused({"order", "nowhere.csv"}, "nowhere.csv cannot be opened");
    expect_refused({"order"}, "TABLE is required");
    expect_refused({"order", table(second), "--quantity", "error_t"}, "did you mean error_T?");
    expect_refused({"order", table(second), "--within", "0.1"}, "--expect");
    expect_refused({"order", table(second), "--junit", "x.xml"}, "--expect");
    expect_refused({"order", table(second), "--expect", "nan"}, "must be above 0");
    expect_refused({"order", table(second), "--expect", "2", "--from", "17"},
                   "--from 17: no row has cells = 17");
    expect_refused({"order", table(second), "--dimension", "4"}, "must be 1, 2 or 3");
    expect_refused({"order", table(second), "--plot", file("plot.png")}, "ends in .svg");
}

TEST_F(Order, ReadsWhatASpreadsheetWrites) {
    const Finished run =
        gated("\xEF\xBB\xBF\"h [mm]\",\"error, T\"\r\n\"4\",\"16\"\r\n2,4\r\n1,1\r\n");
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("error, T"));
}

TEST_F(Order, PrintsNothingButJson) {
    const auto celik = table("cells,phi\n4500,5.863\n18000,6.063\n8000,5.972\n");
    const Finished run = crawford({"order", celik, "--dimension", "2", "--json", "-"});
    EXPECT_EQ(run.status, 0) << run.output;
    const auto json = nlohmann::json::parse(run.output);
    const auto& phi = json.at("quantities").at(0);
    EXPECT_EQ(phi.at("name"), "phi");
    EXPECT_EQ(phi.at("kind"), "value");
    EXPECT_EQ(phi.at("passed"), nullptr);
    EXPECT_EQ(phi.at("verdict"), "monotone");
    EXPECT_EQ(phi.at("values"), (std::vector{5.863, 5.972, 6.063}));
    EXPECT_NEAR(phi.at("fit"), 1.53, 0.005);
    EXPECT_EQ(phi.at("estimate"), reports::default_estimate);
    const auto& estimates = phi.at("estimates");
    ASSERT_EQ(estimates.size(), 4U);
    EXPECT_EQ(estimates.at(0).at("name"), "celik-2008");
    EXPECT_NEAR(estimates.at(0).at("extrapolated"), 6.1685, 5e-5);
    EXPECT_NEAR(estimates.at(0).at("relative_uncertainty"), 0.022, 5e-4);
    EXPECT_EQ(estimates.at(3).at("name"), "eca-hoekstra-2014");
    EXPECT_EQ(estimates.at(3).at("uncertainty"), nullptr);
    EXPECT_THAT(estimates.at(3).at("note"), HasSubstr("needs four grids"));
}

TEST_F(Order, MarksTheEstimateToBelieve) {
    const Finished run = crawford({"order", table("cells,phi\n16,1.4\n32,1.1\n64,1.02\n")});
    EXPECT_THAT(run.output, HasSubstr(fmt::format("\n* {} ", reports::default_estimate)));
    EXPECT_THAT(run.output, HasSubstr(std::string(reports::default_estimate_because)));
}

TEST_F(Order, GatesWithinARange) {
    const auto noisy = table("cells,error\n8,9\n16,1.6e-3\n32,4e-4\n64,1e-4\n128,9e-5\n");
    EXPECT_EQ(crawford({"order", noisy, "--expect", "2"}).status, 1);
    EXPECT_EQ(crawford({"order", noisy, "--expect", "2", "--from", "16", "--to", "64"}).status, 0);
    EXPECT_EQ(crawford({"order", noisy, "--expect", "2", "--from", "32", "--to", "64"}).status, 1);
}

TEST_F(Order, WritesItsFiles) {
    const auto both = table("h [mm],error_T,u\n4,16,1.16\n2,8,1.04\n1,4,1.01\n");
    const Finished run = crawford({"order", both, "--expect", "2", "--json", file("order.json"),
                                   "--plot", file("order.svg"), "--junit", file("order.xml")});
    EXPECT_EQ(run.status, 1) << run.output;
    const auto json = nlohmann::json::parse(content("order.json"));
    EXPECT_EQ(json.at("quantities").at(0).at("passed"), false);
    EXPECT_EQ(json.at("quantities").at(1).at("passed"), true);
    EXPECT_THAT(content("order.svg"), HasSubstr("<svg"));
    EXPECT_THAT(content("order.svg"), HasSubstr("error_T"));
    EXPECT_THAT(content("order.xml"), HasSubstr("tests=\"2\" failures=\"1\""));
    EXPECT_EQ(crawford({"order", both, "--quantity", "u", "--expect", "2"}).status, 0);
}

TEST_F(Order, DrawsWhateverThereIsToDraw) {
    for (const char* text :
         {"h,u\n2,1\n1,1.5\n", "h,error\n2,1\n1,0.5\n", "h,a\001b\n4,16\n2,4\n"}) {
        fs::remove(out_ / "order.svg");
        const Finished run = crawford({"order", table(text), "--plot", file("order.svg")});
        EXPECT_EQ(run.status, 0) << run.output;
        EXPECT_THAT(content("order.svg"), HasSubstr("<svg"));
    }
    expect_refused({"order", table("h,u\n2,1\n1,1\n"), "--plot", file("order.svg")},
                   "nothing to draw");
}

TEST_F(Order, IsNotLostInExtremeNumbers) {
    EXPECT_EQ(gated("h,u\n1e300,1\n1,2\n1e-300,4\n").status, 1);
    EXPECT_EQ(gated("h,u\n1e300,1\n1,2\n0.5,4\n1e-300,4.5\n").status, 1);
    EXPECT_EQ(gated("h,error\n4,1e300\n2,1e-300\n1,1e-308\n").status, 1);
    EXPECT_EQ(gated("h,u\n4,1e308\n2,-1e308\n1,0\n").status, 1);
}

TEST_F(Order, ExplainsItself) {
    const Finished help = crawford({"order", "--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* word : {"--expect", "--dimension", "celik-2008", "Examples:", "Exit codes:"})
        EXPECT_THAT(help.output, HasSubstr(word));
}

}  // namespace
}  // namespace crawford
