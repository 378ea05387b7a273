/// The program as a user meets it: what it says, where, and how it ends. Every test runs the built
/// `crawford`.

#include "tests/program/program.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "reports/ledger.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Program : public ProgramTest {};

TEST_F(Program, ExplainsItselfToANewcomer) {
    const Finished help = crawford({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* word : {"list", "run", "verify", "report", "burn", "Examples:", "Exit codes:",
                             "crawford burn cases/scenes/sandwich.toml"})
        EXPECT_THAT(help.output, HasSubstr(word));
    for (const char* command : {"run", "verify", "report", "burn"}) {
        const Finished more = crawford({command, "--help"});
        EXPECT_EQ(more.status, 0);
        EXPECT_THAT(more.output, HasSubstr("Examples:")) << command;
        EXPECT_THAT(more.output, HasSubstr("--out")) << command;
        EXPECT_THAT(more.output, HasSubstr("Exit codes: 0 done")) << command;
    }
    EXPECT_THAT(crawford({"--version"}).output, testing::StartsWith("crawford 0."));
}

/// The first words of the lines under "Subcommands:".
std::vector<std::string> commands_in(const std::string& help) {
    std::vector<std::string> commands;
    std::istringstream lines(help.substr(help.find("Subcommands:\n")));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("  "))
        if (line[2] != ' ') commands.push_back(line.substr(2, line.find(' ', 2) - 2));
    return commands;
}

TEST_F(Program, ExplainsEveryCommand) {
    const auto commands = commands_in(crawford({"--help"}).output);
    EXPECT_GE(commands.size(), 13U);
    for (const std::string& command : commands)
        for (const char* asked : {"--help", "-h"}) {
            const Finished help = crawford({command, asked});
            EXPECT_EQ(help.status, 0) << command << ": " << help.output;
            EXPECT_THAT(help.output, HasSubstr("Usage: crawford " + command)) << command;
            EXPECT_THAT(help.output, HasSubstr("--help")) << command;
        }
}

TEST_F(Program, RefusesACouplingThatWouldBurnAtAWrongRate) {
    const std::vector<std::string> wrong{"burn",  scenes + "sandwich.toml",
                                         "--set", "time.scheme=bdf2",
                                         "--set", "numerics.coupling=lagged"};
    std::vector<std::string> burn = wrong;
    burn.insert(burn.end(), {"--out", out()});
    expect_refused(burn, "coupling = 0.7");
    EXPECT_FALSE(fs::exists(out())) << "nothing is written";
    std::vector<std::string> check = wrong;
    check.emplace_back("--check");
    EXPECT_EQ(crawford(check).status, 2);
    check.insert(check.end(), {"--set", "numerics.coupling=adiabatic", "--json"});
    const Finished sound = crawford(check);
    EXPECT_EQ(sound.status, 0);
    const auto json = nlohmann::json::parse(sound.output);
    EXPECT_NEAR(json.at("predicted").at("coupling").at("limit"), 1.0 / 3.0, 1e-12);
}

TEST_F(Program, ListsEveryCaseOnALineThatFitsAHundredColumns) {
    const Finished list = crawford({"list"});
    EXPECT_EQ(list.status, 0);
    for (const char* name : {"fig03", "fig04", "fig07", "fig10", "fig11", "slab",
                             "sandwich-mechanical", "sandwich-thermal"})
        EXPECT_THAT(list.output, HasSubstr(std::string("\n") + name + ' '));
    std::istringstream lines(list.output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST_F(Program, NamesTheRightCommandOptionOrCase) {
    expect_refused({}, "a command is missing");
    expect_refused({"lst"}, "unknown command lst; did you mean list?");
    expect_refused({"run", "fig03", "--fidelty", "draft"},
                   "unknown option --fidelty; did you mean --fidelity?");
    expect_refused({"run", "fig03", "--fidelty=draft"}, "did you mean --fidelity?");
    expect_refused({"run", "fig03", "--fidelity", "drft"}, "did you mean draft?");
    expect_refused({"run"}, "no case is named; crawford list shows them, --all draws them all");
    expect_refused({"run", "fig3"}, "no case is called fig3; did you mean fig03?");
    expect_refused({"run", "slab"}, "slab is no case; use crawford verify slab");
    expect_refused({"verify", "slb"}, "no study is called slb; did you mean slab?");
    expect_refused({"verify", "fig03"}, "fig03 is no study; use crawford run fig03");
    expect_refused({"figures", "--help"}, "unknown command figures");
    expect_refused({"run", "--fidelty", "draft", "--help"}, "did you mean --fidelity?");
    expect_refused({"list", "all"}, "unexpected argument all");
}

TEST_F(Program, RefusesGridsThatAreNone) {
    expect_refused({"verify", "slab", "--grids", "32,many"}, "--grids = 32,many");
    expect_refused({"verify", "slab", "--grids", "-32,64"}, "--grids holds -32");
    expect_refused({"verify", "--grids", "31"}, "--grids = 31: no study has any of these grids");
}

TEST_F(Program, RefusesScenesBeforeAnythingIsWritten) {
    const std::string slab = scenes + "slab.toml";
    expect_refused({"burn", "nowhere.toml", "--out", out()}, "nowhere.toml");
    expect_refused({"burn", slab, "--set", "surface.pressure=2 K", "--out", out()},
                   "surface.pressure = \"2 K\" has the wrong dimension; expected Pa");
    expect_refused({"burn", slab, "--set", "surface.presure=2 MPa", "--out", out()},
                   "did you mean pressure?");
    expect_refused({"burn", slab, "--set", "domain.nx=0", "--out", out()}, "domain.nx = 0");
    expect_refused({"burn", slab, "--restart", "nothing.h5", "--out", out()}, "nothing.h5");
    EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Program, RefusesADirectoryItCannotWrite) {
    expect_refused({"run", "fig03", "--out", "/dev/null/out"}, "/dev/null/out");
    expect_refused({"verify", "slab", "--out", "/dev/null/out"}, "/dev/null/out");
    expect_refused({"burn", scenes + "slab.toml", "--out", "/dev/null/out"}, "/dev/null/out");
}

TEST_F(Program, BurnsASceneIntoItsDirectory) {
    const Finished burn = crawford({"burn", scenes + "slab.toml", "--set", "domain.ny=16", "--set",
                                    "time.end=1 ms", "--timing", "--out", out()});
    EXPECT_EQ(burn.status, 0) << burn.output;
    EXPECT_THAT(burn.output, HasSubstr("ended at 0.001 s"));
    EXPECT_THAT(burn.output, HasSubstr("projection")) << "--timing";
    for (const char* file : {"slab.hdf.series", "slab_history.csv", "manifest.json"})
        EXPECT_TRUE(fs::exists(out_ / file)) << file;
    const auto manifest = nlohmann::json::parse(std::ifstream(out_ / "manifest.json"));
    EXPECT_EQ(manifest.at("command").at(1), "burn");
}

TEST_F(Program, LeavesOutWhatIsAMirrorImageAndSaysSo) {
    std::vector<std::string> whole{"burn",  scenes + "sandwich.toml", "--set", "domain.half=false",
                                   "--set", "domain.nx=16",           "--set", "domain.ny=24",
                                   "--set", "time.end=60 us",         "--out", out()};
    const Finished half = crawford(whole);
    EXPECT_EQ(half.status, 0) << half.output;
    EXPECT_THAT(half.output, HasSubstr("left out: half of 16 columns"));
    const auto manifest = nlohmann::json::parse(std::ifstream(out_ / "manifest.json"));
    EXPECT_THAT(manifest.at("left_out").get<std::string>(), HasSubstr("half of 16 columns"));
    EXPECT_THAT(manifest.at("scene").get<std::string>(), HasSubstr("half = false"));
    whole.emplace_back("--as-written");
    const Finished all = crawford(whole);
    EXPECT_EQ(all.status, 0) << all.output;
    EXPECT_THAT(all.output, Not(HasSubstr("left out")));
    // A checkpoint of all columns is gone on from with all.
    whole.pop_back();
    whole.insert(whole.end(), {"--set", "time.end=100 us", "--restart",
                               (out_ / "sandwich_checkpoint_000003.h5").string()});
    const Finished on = crawford(whole);
    EXPECT_EQ(on.status, 0) << on.output;
    EXPECT_THAT(on.output, Not(HasSubstr("left out")));
}

TEST_F(Program, ChoosesGridAndStepsForAnAccuracyAndSaysWhatBecameOfIt) {
    const std::string scene = scenes + "sandwich.toml";
    const Finished run =
        crawford({"burn", scene, "--accuracy", "1 %", "--set", "domain.nx=16", "--set",
                  "time.until_steady=", "--set", "time.end=2 ms", "--out", out()});
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("preset draft: domain.ny="));
    EXPECT_THAT(run.output, HasSubstr("on half the grid"));
    const auto manifest = nlohmann::json::parse(std::ifstream(out_ / "manifest.json"));
    EXPECT_THAT(manifest.at("scene").get<std::string>(), HasSubstr("nx = 16")) << "--set wins";
    EXPECT_EQ(manifest.at("accuracy").at("preset"), "draft");
    EXPECT_GT(manifest.at("accuracy").at("estimated"), 0.0);
    expect_refused({"burn", scene, "--accuracy", "0.01 %"}, "the finest preset promises 0.1 %");
    for (const char* wrong : {"good", "-1 %", "0"})
        expect_refused({"burn", scene, std::string("--accuracy=") + wrong}, "give a part of V");
    expect_refused({"burn", scene, "--preset", "best"}, "choose one of draft, paper, fine");
    EXPECT_THAT(crawford({"burn", "--help"}).output, HasSubstr("draft  V to 1 %; measured: "));
}

TEST_F(Program, WritesAPackThatASceneReads) {
    const std::string file = (out_ / "pack.csv").string();
    const std::string recipe = scenes + "random_pack.toml";
    const Finished made = crawford({"pack", recipe, "--set", "morphology.seed=3", "--out", file});
    EXPECT_EQ(made.status, 0) << made.output;
    EXPECT_THAT(made.output, HasSubstr("40 discs, area fraction 0.72, smallest gap 3."));
    EXPECT_TRUE(fs::exists(file));
    const Finished burnt =
        crawford({"burn", scenes + "pack.toml", "--set", "morphology.file=" + file, "--set",
                  "morphology.period=774.5 um", "--set", "time.end=25 us", "--out", out_.string()});
    EXPECT_EQ(burnt.status, 0) << burnt.output;
    const Finished jammed = crawford({"pack", recipe, "--set", "morphology.area_fraction=0.9"});
    EXPECT_EQ(jammed.status, 2);
    EXPECT_THAT(jammed.output, HasSubstr("jammed at an area fraction of 0.7"));
    EXPECT_EQ(crawford({"pack", scenes + "slab.toml"}).status, 2);
}

TEST_F(Program, SaysWithCodeThreeThatTheNumbersFailed) {
    const Finished burn = crawford(
        {"burn", scenes + "slab.toml", "--set", "time.step=250 us", "--quiet", "--out", out()});
    EXPECT_EQ(burn.status, 3) << burn.output;
    EXPECT_THAT(burn.output, HasSubstr("crawford: remark: crossing_y = 1.2, limit 1: "));
    EXPECT_THAT(burn.output, HasSubstr("the last good state is kept in"));
}

TEST_F(Program, RefusesBeforehandAStepThatCannotGoWell) {
    const std::vector<std::string> burn{
        "burn",  scenes + "slab.toml",           "--set",   "time.step=10 ms",
        "--set", "output.snapshots_every=10 ms", "--quiet", "--out",
        out()};
    expect_refused(burn, "reduce time.step to 200 us or less");
    EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Program, DrawsAFigureWithItsNumbersAndManifest) {
    const Finished run = crawford({"run", "fig03", "--fidelity", "draft", "--out", out()});
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("error: distance to the exact solution"));
    for (const char* file : {"fig03a.svg", "fig03d.svg", "fig03_nodes.csv"})
        EXPECT_TRUE(fs::exists(out_ / "figures" / file)) << file;
    const auto manifest =
        nlohmann::json::parse(std::ifstream(out_ / "figures" / "fig03_manifest.json"));
    EXPECT_EQ(manifest.at("fidelity"), "draft");
    EXPECT_EQ(manifest.at("scenes").size(), 1U);
    EXPECT_NEAR(manifest.at("findings").at(0).at("value").get<double>(), 1054.35, 0.1)
        << "T_s of the Eulerian slab; the draft grid is within 0.1 K";
}

TEST_F(Program, TellsProgressOnlyWhenItMay) {
    const Finished loud = crawford({"run", "fig03", "--fidelity", "draft", "--out", out()});
    EXPECT_THAT(loud.output, HasSubstr("fig03: done in"));
    const Finished quiet =
        crawford({"run", "fig03", "--fidelity", "draft", "--quiet", "--out", out()});
    EXPECT_THAT(quiet.output, Not(HasSubstr("done in")));
}

TEST_F(Program, ListsStudiesForPrograms) {
    std::istringstream lines(crawford({"list", "--studies"}).output);
    std::set<std::string> names;
    std::string name;
    for (double seconds = 0.0; lines >> name >> seconds;) {
        EXPECT_GT(seconds, 0.0) << name;
        EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    }
    EXPECT_TRUE(lines.eof()) << "a line is not a name and a number";
    EXPECT_TRUE(names.contains("slab"));
    EXPECT_FALSE(names.contains("fig03"));
}

/// One study of the slab, on grids that take no time.
const std::string one = "slab, AP, beta = 3 alpha K";

TEST_F(Program, LeavesAQuickLookUngatedAndSaysSo) {
    const Finished verify =
        crawford({"verify", one, "--grids", "16,32", "--quiet", "--out", out()});
    EXPECT_EQ(verify.status, 0) << verify.output;
    EXPECT_THAT(verify.output, HasSubstr("not gated: too few grids"));
    EXPECT_THAT(verify.output, HasSubstr("no verification"));
    const auto results = nlohmann::json::parse(std::ifstream(out_ / "verify.json"));
    EXPECT_FALSE(results.at("passed").get<bool>());
    EXPECT_FALSE(results.at("revision").get<std::string>().empty());
    ASSERT_EQ(results.at("studies").size(), 1U) << "one study of the entry was named";
    EXPECT_EQ(results.at("studies").at(0).at("command"),
              "build/crawford verify '" + one + "' --grids 16,32");
    EXPECT_EQ(results.at("studies").at(0).at("source"), "cases/verify/slab/slab.cpp");
    for (const auto& gate : results.at("gates"))
        EXPECT_EQ(gate.at("verdict"), "too few grids to gate");
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST_F(Program, RebuildsTheReportFromItsResults) {
    expect_refused({"report", "--out", out()}, "holds no results: no figures, no verify/verify");
    const auto studies = out_ / "verify";
    crawford({"verify", one, "--grids", "16,32", "--quiet", "--out", studies.string()});
    const auto page = studies / "report.html";
    const auto written = text_of(page);
    EXPECT_THAT(written,
                HasSubstr("how exact is the solver"));  // the page of cases/verify/slab/slab.cpp
    for (const auto& directory : {out_, studies}) {
        fs::remove(page);
        const Finished report = crawford({"report", "--out", directory.string()});
        EXPECT_EQ(report.status, 0) << report.output;
        EXPECT_THAT(report.output, HasSubstr("report.html"));
        EXPECT_EQ(text_of(page), written);
    }
    std::ofstream(studies / "verify.json") << "half a fi";
    expect_refused({"report", "--out", out()}, "writes it anew");
}

TEST_F(Program, MakesPagesOfWhatWasDrawn) {
    crawford({"run", "fig01", "table1", "--fidelity", "draft", "--quiet", "--out", out()});
    const auto figures = out_ / "figures";
    for (const char* name : {"fig01.html", "table1.html", "index.html"}) fs::remove(figures / name);
    reports::Ledger ledger;
    ledger.manifest = R"({"revision":"abc"})";
    ledger.rows = {{.claim = "wave speed", .where = "Table 1", .entry = "table1"}};
    reports::write(figures / "ledger.json", ledger);
    crawford({"verify", one, "--grids", "16,32", "--quiet", "--out", (out_ / "verify").string()});
    EXPECT_THAT(text_of(out_ / "verify" / "report.html"), Not(HasSubstr("index.html")));

    const Finished report = crawford({"report", "--out", out()});
    EXPECT_EQ(report.status, 0) << report.output;
    EXPECT_THAT(report.output, HasSubstr("figures/index.html"));
    const auto page = text_of(figures / "table1.html");
    EXPECT_THAT(page,
                HasSubstr("<h1>Table 1: the properties"));  // the page of cases/paper/table1.cpp
    EXPECT_THAT(page, HasSubstr("<img src=\"table1.svg\""));
    EXPECT_THAT(page, HasSubstr("href=\"table1_properties.csv\""));
    EXPECT_THAT(page, HasSubstr("build/crawford run table1 --fidelity draft --out " + out()));
    EXPECT_THAT(page, HasSubstr("href=\"ledger.html#claim-Table-1-wave-speed\""));
    EXPECT_THAT(text_of(figures / "ledger.html"), HasSubstr("href=\"table1.html\""));
    const auto index = text_of(figures / "index.html");
    EXPECT_THAT(index, HasSubstr("href=\"../verify/report.html#entry-slab\""));
    EXPECT_THAT(index, HasSubstr("<h3>material properties</h3>"));
    EXPECT_THAT(index, HasSubstr("Not drawn: <code>build/crawford run coverage extremes fig02"));
    EXPECT_THAT(index, Not(HasSubstr("#entry-surface\""))) << "that study has not run";
    EXPECT_THAT(text_of(out_ / "verify" / "report.html"),
                HasSubstr("href=\"../figures/index.html\""));

    std::ofstream(figures / "ledger.json") << "{}";
    expect_refused({"report", "--out", out()}, "ledger.json: manifest is missing");
}

}  // namespace
}  // namespace crawford
