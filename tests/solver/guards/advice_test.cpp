// Every refusal says what to do. Here it is done, to the letter, and the scene then burns.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {
namespace {

using Overrides = std::vector<std::string>;

Scene scene_with(const std::string& file, const Overrides& overrides) {
    return read_scene(source_path("cases/scenes/" + file), overrides);
}

std::string refusal_of(const Scene& scene) {
    try {
        refuse(predicted(scene));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// What a line advises, as overrides of the scene it was said of. Where it names no value, half as
/// much again, or a tenth.
Overrides advised(const std::string& line, const Scene& scene) {
    const std::string advice = line.substr(line.rfind("; ") + 2);
    std::smatch match;
    if (std::regex_search(advice, match, std::regex(R"(([a-z]+\.[a-z_]+) = ("[^"]+"))")))
        return {match.str(1) + '=' + match.str(2)};
    if (std::regex_search(advice, match, std::regex(R"(time\.step to ([^ ]+) us)")))
        return {"time.step=" + match.str(1) + " us"};
    if (std::regex_search(advice, match, std::regex(R"(materials\.(\w+)\.activation_temperature)")))
        for (const Material& m : scene.morphology.materials)
            if (m.name == match.str(1))
                return {fmt::format("{}={} K", match.str(), 1.5 * m.activation_temperature)};
    if (advice.find("stress_work as numerics.thermal_stress") != std::string::npos)
        return {"numerics.stress_work=3 alpha K"};  // the scene's own thermal_stress
    if (advice.find("lower the flux") != std::string::npos)
        return {fmt::format("surface.heat_flux={} W/m2", 0.1 * scene.surface.heat_flux[0])};
    return {};
}

struct Refused {
    std::string file;
    Overrides overrides;
};

/// The name is GoogleTest's.
// NOLINTNEXTLINE(readability-identifier-naming)
void PrintTo(const Refused& refused, std::ostream* out) {
    *out << refused.file;
    for (const std::string& one : refused.overrides) *out << ' ' << one;
}

class Advice : public testing::TestWithParam<Refused> {};

TEST_P(Advice, FollowedToTheLetterLeadsToARunThatWorks) {
    const auto& [file, given] = GetParam();
    Overrides overrides = given;
    std::string line = refusal_of(scene_with(file, overrides));
    ASSERT_NE(line, "") << "nothing is refused here";
    for (int round = 0; round < 12 && !line.empty(); ++round) {
        const Overrides more = advised(line, scene_with(file, overrides));
        ASSERT_FALSE(more.empty()) << "advises nothing to do: " << line;
        overrides.insert(overrides.end(), more.begin(), more.end());
        line = refusal_of(scene_with(file, overrides));
    }
    ASSERT_EQ(line, "");
    Simulation simulation(scene_with(file, overrides));
    run_steps(simulation, 60);
    EXPECT_TRUE(std::isfinite(simulation.summary().largest_temperature));
}

// Of two numbers that ask for a shorter step, one asks for a shorter one than the other.
TEST(AdviceOfAStep, IsOneForAllThatAskForAShorterOne) {
    const Overrides burning{"physics.regression=pyrolysis", "domain.ny=48"};
    for (const char* clustering : {"domain.clustering=1", "domain.clustering=3"}) {
        Overrides overrides = burning;
        overrides.insert(overrides.end(), {clustering, "time.step=5 ms"});
        const std::string line = refusal_of(scene_with("slab.toml", overrides));
        const Overrides more = advised(line, scene_with("slab.toml", overrides));
        overrides.insert(overrides.end(), more.begin(), more.end());
        for (const Guard& guard : predicted(scene_with("slab.toml", overrides)))
            if (guard.name == "front_coupling" || guard.name == "crossing_y") {
                EXPECT_EQ(guard.beyond, Beyond::nothing) << in_words(guard) << " after " << line;
            }
    }
}

const Overrides coarse{"domain.nx=16", "domain.ny=24"};

Refused refused(const std::string& file, Overrides overrides) {
    if (file != "slab.toml") overrides.insert(overrides.end(), coarse.begin(), coarse.end());
    return {file, std::move(overrides)};
}

INSTANTIATE_TEST_SUITE_P(
    OfRefusals, Advice,
    testing::Values(
        refused("sandwich.toml", {"time.scheme=bdf2", "numerics.coupling=lagged"}),
        refused("pack.toml", {"time.scheme=bdf2", "numerics.coupling=lagged"}),
        refused("sandwich.toml", {"materials.binder.thermal_expansion=4e-4 1/K", "time.scheme=bdf2",
                                  "numerics.stress_work=alpha K"}),
        refused("sandwich.toml", {"materials.binder.thermal_expansion=3e-4 1/K",
                                  "numerics.heat_capacity=c_v", "numerics.coupling=lagged"}),
        refused("sandwich.toml", {"time.step=5 ms"}), refused("pack.toml", {"time.step=5 ms"}),
        refused("slab.toml", {"time.step=5 ms"}),
        refused("sandwich.toml", {"time.step=0.2 ms", "surface.heat_flux.AP=2000 cal/(s cm2)"}),
        refused("sandwich.toml", {"materials.AP.activation_temperature=3000 K"}),
        refused("slab.toml", {"surface.burn_rate=1e-9 m/s"})));

}  // namespace
}  // namespace crawford
