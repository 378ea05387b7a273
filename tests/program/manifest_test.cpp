/// What the manifest of a burn says when it is done: what it came to, what was random, how the paper
/// was read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"
#include "tests/program_path.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Of a burn of a shipped scene on a coarse grid.
nlohmann::json manifest_of(const std::string& scene, const std::vector<std::string>& set) {
    const Scratch scratch;
    const auto& out = scratch.path();
    std::vector<std::string> command{program_path(), "burn", "--quiet", "--out", out.string()};
    command.push_back((source_path("cases/scenes") / scene).string());
    for (const std::string& key : set) command.insert(command.end(), {"--set", key});
    const auto run = run_program(command);
    EXPECT_EQ(run.status, 0) << run.output;
    return nlohmann::json::parse(std::ifstream(out / "manifest.json"));
}

TEST(ProgramManifest, NamesTheSeedAndTheReadings) {
    const auto manifest =
        manifest_of("random_pack.toml", {"morphology.seed=7", "domain.nx=24", "domain.ny=32",
                                         "time.end=50 us", "numerics.readings=consistent"});
    EXPECT_EQ(manifest.at("seeds"), nlohmann::json::array({7}));
    EXPECT_THAT(manifest.at("scene").get<std::string>(), HasSubstr("readings = \"consistent\""));
    const auto& results = manifest.at("results");
    EXPECT_GT(results.at("strain_within_5_um_of_max").at("value").get<double>(), 0.0);
    EXPECT_FALSE(results.contains("steady")) << "the scene does not ask";
}

TEST(ProgramManifest, EndsWithWhatTheRunCameTo) {
    const auto manifest =
        manifest_of("sandwich.toml",
                    {"domain.nx=16", "domain.ny=24", "time.step=100 us", "physics.mechanics=false",
                     "physics.reference_map=", "time.until_steady=1e-4"});
    const auto& results = manifest.at("results");
    EXPECT_EQ(results.at("steady"), true);
    EXPECT_EQ(results.at("steady_at").at("value"), manifest.at("time_seconds"));
    EXPECT_FALSE(results.contains("strain_within_5_um_of_max")) << "there is none";
    const double rate = results.at("mean_burn_rate").at("value"),
                 front = results.at("regression_rate").at("value");
    EXPECT_NEAR(rate, 0.0048, 0.0003) << "as on the shipped grid, roughly";
    EXPECT_GT(front, rate) << "V counts the slope";
    EXPECT_NEAR(results.at("largest_temperature").at("value"), 980.0, 20.0);
    EXPECT_TRUE(manifest.at("seeds").empty());
}

}  // namespace
}  // namespace crawford
