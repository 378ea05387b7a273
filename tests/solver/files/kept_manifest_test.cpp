// What a manifest says is read again, and a damaged one is refused by the name of what is wrong.
#include "solver/files/kept_manifest.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;
using Kind = ManifestOutcome::Kind;

class OutputManifest : public OutputTest {
protected:
    std::filesystem::path file() const { return directory / "manifest.json"; }

    void write_one() const {
        Manifest manifest;
        manifest.outcome = {Kind::done};
        manifest.command = {"crawford", "burn", "a b.toml"};
        manifest.scene = "title = \"one\"\n";
        manifest.seeds = {7, 1UL << 63};
        manifest.restarted_from = "out/run_checkpoint_000020.h5";
        manifest.last_step = 50;
        manifest.time = 1e-3;
        manifest.met = {{.name = "onset",
                         .value = 3.0,
                         .limit = 2.0,
                         .beyond = Beyond::remark,
                         .text = "too steep"}};
        manifest.results = RunResults{.regression_rate = 0.004,
                                      .mean_burn_rate = 0.0038,
                                      .largest_temperature = 900.0,
                                      .strain_about_peak = 0.02,
                                      .steady = false};
        write_manifest(file(), manifest);
    }
    /// As it is with one member changed.
    void change(const std::string& member, const Json& value) const {
        write_one();
        auto json = Json::parse(content(file()));
        json.at(Json::json_pointer(member)) = value;
        put(file(), json.dump());
    }
    std::string refusal() const {
        return message_of<InputError>([&] { kept_manifest(directory); });
    }
};

TEST_F(OutputManifest, IsReadAsItWasWritten) {
    write_one();
    const auto kept = kept_manifest(directory).value();
    EXPECT_EQ(kept.outcome.kind, Kind::done);
    EXPECT_EQ(kept.solver_fingerprint, solver_fingerprint());
    EXPECT_EQ(kept.command, (std::vector<std::string>{"crawford", "burn", "a b.toml"}));
    EXPECT_EQ(kept.scene, "title = \"one\"\n");
    EXPECT_EQ(kept.seeds, (std::vector<std::uint64_t>{7, 1UL << 63}));
    EXPECT_EQ(kept.restarted_from, "out/run_checkpoint_000020.h5");
    EXPECT_EQ(kept.last_step, 50);
    EXPECT_EQ(kept.time, 1e-3);
    EXPECT_THAT(kept.remarks, testing::ElementsAre(testing::Pair("onset", HasSubstr("too steep"))));
    ASSERT_TRUE(kept.results.has_value());
    EXPECT_EQ(kept.results->regression_rate, 0.004);
    EXPECT_EQ(kept.results->mean_burn_rate, 0.0038);
    EXPECT_EQ(kept.results->largest_temperature, 900.0);
    EXPECT_EQ(kept.results->strain_about_peak, 0.02);
    EXPECT_EQ(kept.results->steady, false);
}

TEST_F(OutputManifest, OfAnEarlierVersionMayLackWhatWasAddedLater) {
    write_one();
    auto json = Json::parse(content(file()));
    for (const char* later : {"seeds", "remarks", "restarted_from", "results"}) json.erase(later);
    put(file(), json.dump());
    const auto kept = kept_manifest(directory).value();
    EXPECT_TRUE(kept.seeds.empty());
    EXPECT_TRUE(kept.remarks.empty());
    EXPECT_FALSE(kept.results.has_value());
}

TEST_F(OutputManifest, IsNotThereOrOfSomethingElse) {
    EXPECT_FALSE(kept_manifest(directory).has_value());
    EXPECT_FALSE(kept_manifest(directory / "nowhere").has_value());
    put(file(), R"({"name": "a page", "scene": 1, "outcome": 2, "program": "another"})");
    EXPECT_FALSE(kept_manifest(directory).has_value());
    put(file(), "[1, 2]");
    EXPECT_FALSE(kept_manifest(directory).has_value());
}

TEST_F(OutputManifest, ThatIsDamagedNamesWhatIsWrong) {
    put(file(), "{\"program\": ");
    EXPECT_THAT(refusal(), HasSubstr(file().string() + " is damaged: parse error at line 1"));
    const std::vector<std::tuple<const char*, Json, const char*>> cases = {
        {"/scene", 5, "scene is no text"},
        {"/outcome", "don", "outcome is no outcome of a burn"},
        {"/outcome", nullptr, "outcome is no text"},
        {"/command", "crawford", "command is no list"},
        {"/command/1", 1.5, "command[1] is no text"},
        {"/solver_fingerprint", Json::array(), "solver_fingerprint is no text"},
        {"/last_step", 1.5, "last_step is no whole number"},
        {"/last_step", 1UL << 63, "last_step is too large"},
        {"/time_seconds", "1", "time_seconds is no number"},
        {"/seeds", 7, "seeds is no list"},
        {"/seeds/0", -7, "seeds[0] is no whole number"},
        {"/remarks/0", 7, "remarks[0] is no object"},
        {"/results", 7, "results is no object"},
        {"/results/mean_burn_rate/value", "x", "results.mean_burn_rate.value is no number"},
        {"/results/steady", 1, "results.steady is neither true nor false"},
    };
    for (const auto& [member, value, expected] : cases) {
        change(member, value);
        EXPECT_THAT(refusal(), HasSubstr(std::string(" is damaged: ") + expected)) << member;
    }
    std::filesystem::remove(file());
    std::filesystem::create_directory(file());
    EXPECT_THAT(refusal(), HasSubstr("cannot be read"));
}

TEST(OutputManifestOutcome, IsReadAsItWasWritten) {
    for (const ManifestOutcome& outcome : {ManifestOutcome{Kind::running},
                                           {Kind::done},
                                           {Kind::interrupted},
                                           {Kind::failed, "step 7"},
                                           {Kind::cut_off, "out of memory"}}) {
        const auto again = manifest_outcome(text_of(outcome)).value();
        EXPECT_EQ(again.kind, outcome.kind);
        EXPECT_EQ(again.reason, outcome.reason);
    }
    EXPECT_EQ(text_of({Kind::failed, "step 7"}), "failed: step 7");
    EXPECT_EQ(text_of({Kind::cut_off, "out of memory"}), "cut off: out of memory");
    for (const char* none : {"", "failed", "done ", "cut off"})
        EXPECT_FALSE(manifest_outcome(none).has_value()) << none;
}

}  // namespace

}  // namespace crawford
