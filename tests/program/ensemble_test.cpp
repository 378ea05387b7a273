/// Many burns: what lies where, what goes on, what is gathered.

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

const std::string tiny = source_path("workflow/tiny.toml").string();

std::string content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Words joined(Words first, const Words& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

class ProgramEnsemble : public ProgramTest {
protected:
    /// Long enough to be killed amid it.
    Words burn(const std::string& folder, const Words& more = {}) const {
        return joined({"burn", tiny, "--quiet", "--out", (out_ / folder).string(), "--resume"},
                      more);
    }
    Words slow(const std::string& folder) const {
        return burn(folder, {"--set", "time.end=40 ms", "--set", "domain.nx=32"});
    }
    nlohmann::json listed() const {
        const Finished list = crawford({"runs", "--list", "--json", "--out", out()});
        EXPECT_EQ(list.status, 0) << list.output;
        return nlohmann::json::parse(list.output);
    }
    std::string history(const std::string& folder) const {
        return content(out_ / folder / "tiny_history.csv");
    }
    void kill_amid(const std::string& signal, const std::string& folder) const {
        const std::string there = (out_ / folder / "tiny_checkpoint_000060.h5").string();
        signalled(signal, "test -e " + there, slow(folder));
    }
};

TEST_F(ProgramEnsemble, KnowsASceneByAKeyInFull) {
    const auto key = [](const Words& set) {
        const Finished said = crawford(joined({"runs", "--key", tiny}, set));
        EXPECT_EQ(said.status, 0) << said.output;
        return said.output;
    };
    const std::string plain = key({});
    EXPECT_EQ(plain.size(), 37U) << plain;
    EXPECT_EQ(key({"--set", "title=another", "--set", "output.checkpoint_every=1 ms"}), plain);
    EXPECT_EQ(key({"--set", "time.end=0.008 s"}), plain);
    EXPECT_NE(key({"--set", "morphology.seed=2"}), plain);
    EXPECT_NE(key({"--set", "numerics.readings=paper", "--set", "time.end=9 ms"}), plain);
    crawford(burn("one"));
    EXPECT_EQ(listed().at(0).at("key").get<std::string>() + '\n', plain);
    const auto json = nlohmann::json::parse(crawford({"runs", "--key", tiny, "--json"}).output);
    EXPECT_EQ(json.at("key").get<std::string>() + '\n', plain);
}

TEST_F(ProgramEnsemble, ListsWhatIsThereAndInWhatState) {
    EXPECT_EQ(crawford(burn("a")).status, 0);
    EXPECT_EQ(crawford({"burn", scenes + "slab.toml", "--set", "time.step=250 us", "--quiet",
                        "--out", (out_ / "b").string()})
                  .status,
              3);
    kill_amid("KILL", "c");
    fs::create_directories(out_ / "d");
    std::ofstream(out_ / "d" / "manifest.json") << "{\"program\": ";
    const auto list = listed();
    ASSERT_EQ(list.size(), 4U);
    EXPECT_EQ(list.at(0).at("state"), "done");
    EXPECT_GT(list.at(0).at("results").at("regression_rate").at("value"), 0.0);
    EXPECT_EQ(list.at(1).at("state"), "failed");
    EXPECT_THAT(list.at(1).at("reason").get<std::string>(), HasSubstr("step"));
    EXPECT_EQ(list.at(2).at("state"), "cut off");
    EXPECT_EQ(list.at(3).at("state"), "unreadable");
    EXPECT_THAT(crawford({"runs", "--list", "--out", out()}).output,
                HasSubstr("4 burns in " + out() + ", 1 of them done"));
    expect_refused({"gather", out(), "--out", out() + "/table"},
                   "d/manifest.json is damaged: parse error");
}

/// The burn is held still while it is looked at: it cannot have ended.
TEST_F(ProgramEnsemble, ListsABurnThatGoesOnAsRunning) {
    Words command{"sh",
                  "-c",
                  "program=$1; out=$2; until=$3; shift 3; "
                  "\"$program\" \"$@\" >/dev/null 2>&1 & child=$!; "
                  "until test -e \"$until\"; do kill -0 $child || break; sleep 0.05; done; "
                  "kill -STOP $child; \"$program\" runs --list --json --out \"$out\"; "
                  "kill -KILL $child; wait $child 2>/dev/null; true",
                  "sh",
                  program_path(),
                  out(),
                  (out_ / "a" / "tiny_checkpoint_000060.h5").string()};
    const Finished amid = run_program(joined(command, slow("a")));
    const auto list = nlohmann::json::parse(amid.output);
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list.at(0).at("state"), "running");
    EXPECT_EQ(listed().at(0).at("state"), "cut off") << "it has been killed";
}

TEST_F(ProgramEnsemble, GoesOnFromAKillToTheSameBits) {
    EXPECT_EQ(crawford(slow("unbroken")).status, 0);
    kill_amid("KILL", "killed");
    ASSERT_NE(history("killed"), history("unbroken"));
    EXPECT_EQ(crawford(slow("killed")).status, 0);
    EXPECT_EQ(history("killed"), history("unbroken"));
    const auto manifest = nlohmann::json::parse(content(out_ / "killed" / "manifest.json"));
    EXPECT_GE(manifest.at("first_step"), 40) << "not from nothing";
    EXPECT_THAT(crawford(slow("killed")).output, HasSubstr("done before"));
    EXPECT_THAT(crawford(burn("killed")).output, Not(HasSubstr("done before"))) << "another end";
}

TEST_F(ProgramEnsemble, GoesOnFromTheVeryStateThatASignalLeft) {
    EXPECT_EQ(crawford(slow("unbroken")).status, 0);
    kill_amid("TERM", "ended");
    const auto before = nlohmann::json::parse(content(out_ / "ended" / "manifest.json"));
    ASSERT_EQ(before.at("outcome"), "interrupted");
    EXPECT_EQ(crawford(slow("ended")).status, 0);
    const auto after = nlohmann::json::parse(content(out_ / "ended" / "manifest.json"));
    EXPECT_EQ(after.at("first_step"), before.at("last_step"));
    EXPECT_EQ(history("ended"), history("unbroken"));
}

TEST_F(ProgramEnsemble, PassesOverACheckpointThatIsDamagedOrOfTheEnd) {
    EXPECT_EQ(crawford(burn("whole")).status, 0);
    const std::string expected = history("whole");
    // As if killed between the last checkpoint and the manifest.
    const fs::path manifest = out_ / "whole" / "manifest.json";
    auto json = nlohmann::json::parse(content(manifest));
    json["outcome"] = "running";
    json.erase("results");
    std::ofstream(manifest) << json.dump();
    fs::resize_file(out_ / "whole" / "tiny_checkpoint_000060.h5", 1000);
    EXPECT_EQ(crawford(burn("whole")).status, 0);
    json = nlohmann::json::parse(content(manifest));
    EXPECT_EQ(json.at("outcome"), "done");
    EXPECT_EQ(json.at("first_step"), 40);
    EXPECT_EQ(history("whole"), expected);
}

TEST_F(ProgramEnsemble, TakesNothingThatAnotherSolverHasLeft) {
    EXPECT_EQ(crawford(burn("old")).status, 0);
    const fs::path manifest = out_ / "old" / "manifest.json";
    auto json = nlohmann::json::parse(content(manifest));
    json["solver_fingerprint"] = "another";
    std::ofstream(manifest) << json.dump();
    EXPECT_EQ(listed().at(0).at("is_of_this_solver"), false);
    EXPECT_THAT(crawford(burn("old")).output, Not(HasSubstr("done before")));
    EXPECT_EQ(listed().at(0).at("is_of_this_solver"), true);
}

TEST_F(ProgramEnsemble, GathersPacksToAPointAndKeepsWhatFailed) {
    for (const char* seed : {"1", "2", "3"})
        EXPECT_EQ(crawford(burn(seed, {"--set", std::string("morphology.seed=") + seed})).status,
                  0);
    // A failure is known by its manifest alone.
    const fs::path manifest = out_ / "3" / "manifest.json";
    auto json = nlohmann::json::parse(content(manifest));
    json["outcome"] = "failed: step 7: heat: of its own";
    std::ofstream(manifest) << json.dump();
    const std::string table = (out_ / "table").string();
    const Finished gathered = crawford({"gather", out(), "--out", table, "--interval", "2 %"});
    EXPECT_EQ(gathered.status, 0) << gathered.output;
    EXPECT_THAT(gathered.output, HasSubstr("2 of 3 packs done"));
    const auto found = nlohmann::json::parse(content(out_ / "table" / "ensemble.json"));
    ASSERT_EQ(found.at("points").size(), 1U);
    EXPECT_NEAR(found.at("points").at(0).at("conditions").at("area_fraction").at("value"), 0.6,
                1e-9);
    EXPECT_EQ(found.at("burns").at(2).at("reason"), "step 7: heat: of its own");
    EXPECT_THAT(content(out_ / "table" / "points.csv"),
                HasSubstr("V packs for a half-width of 2 % [-]"));
    EXPECT_TRUE(fs::exists(out_ / "table" / "figures" / "ensemble_pressure_V.svg"));
    EXPECT_FALSE(fs::exists(out_ / "table" / "figures" / "ensemble_pressure_strain.svg"))
        << "rigid";
    EXPECT_THAT(content(out_ / "table" / "ensemble.html"), HasSubstr("ensemble_pressure_V.svg"));
}

TEST_F(ProgramEnsemble, GathersOfAListWhatItNamesAlone) {
    for (const char* seed : {"1", "2"})
        EXPECT_EQ(crawford(burn(seed, {"--set", std::string("morphology.seed=") + seed})).status,
                  0);
    const std::string list = (out_ / "folders.txt").string();
    const auto gathered = [&] {
        return crawford({"gather", "--from", list, "--out", (out_ / "table").string()});
    };
    std::ofstream(list) << (out_ / "2").string() << '\n';
    EXPECT_THAT(gathered().output, HasSubstr("1 of 1 packs done"));
    const auto found = nlohmann::json::parse(content(out_ / "table" / "ensemble.json"));
    EXPECT_EQ(found.at("burns").at(0).at("seed"), "2");

    std::ofstream(list, std::ios::app) << (out_ / "3").string() << '\n';
    EXPECT_THAT(gathered().output, HasSubstr("3 is no folder"));
    fs::create_directories(out_ / "3");
    const Finished short_of_one = gathered();
    EXPECT_EQ(short_of_one.status, 2);
    EXPECT_THAT(short_of_one.output, HasSubstr("3 has no burns"));

    std::ofstream(list, std::ios::trunc).close();
    expect_refused({"gather", "--from", list, "--out", out()}, "no folder is named");
    expect_refused({"gather", "--out", out()}, "no folder is named");
    expect_refused({"gather", "--from", list + ".old", "--out", out()}, "cannot be read");
}

TEST_F(ProgramEnsemble, CountsRatesOverTheTimeThatWasAskedFor) {
    EXPECT_EQ(crawford(burn("one")).status, 0);
    EXPECT_THAT(crawford({"gather", out(), "--out", (out_ / "table").string()}).output,
                HasSubstr("1 of 1 packs done: too few for an interval"));
    const auto v = [&](const std::string& after) {
        const std::string table = (out_ / "table").string();
        EXPECT_EQ(crawford({"gather", out(), "--out", table, "--after", after}).status, 0);
        const auto json = nlohmann::json::parse(content(out_ / "table" / "ensemble.json"));
        return json.at("burns")
            .at(0)
            .at("values")
            .at("regression rate V")
            .at("value")
            .get<double>();
    };
    const auto results = listed().at(0).at("results");
    EXPECT_NEAR(v("7.9 ms"), 100.0 * results.at("regression_rate").at("value").get<double>(), 1e-12)
        << "the last step alone";
    EXPECT_LT(v("0 s"), 0.9 * v("4 ms")) << "it had to ignite";
}

TEST_F(ProgramEnsemble, RefusesWhatMakesNoSense) {
    expect_refused({"runs"}, "name one of --list and --key SCENE");
    expect_refused({"runs", "--list", "--out", out()}, "is no folder; name one with burns");
    expect_refused({"runs", "--key", "nowhere.toml"}, "nowhere.toml");
    expect_refused({"runs", "--key", tiny, "--set", "time.ende=1 s"}, "did you mean end?");
    expect_refused({"runs", "--lst"}, "did you mean --list?");
    fs::create_directories(out_);
    expect_refused({"gather", out(), "--out", out() + "/t"}, "has no burns");
    expect_refused({"gather", out(), "--out", out() + "/t", "--interval", "none"},
                   "--interval = none; give a part above 0");
    expect_refused({"gather", out(), "--out", out() + "/t", "--confidence", "100 %"},
                   "must be below 100 %");
    expect_refused({"gather", out(), "--out", out() + "/t", "--after", "2 K"}, "--after = \"2 K\"");
    expect_refused({"gather", out(), "--out", out() + "/t", "--after", "-1 s"}, "before the start");
    crawford(burn("one"));
    expect_refused({"gather", out(), "--out", out() + "/t", "--after", "1 s"},
                   "ends at 8 ms, not after 1000 ms; give --after an earlier time");
    expect_refused(joined(burn("one"), {"--restart", "some.h5"}), "excludes");
}

}  // namespace
}  // namespace crawford
