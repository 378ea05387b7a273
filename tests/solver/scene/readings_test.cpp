/// Named readings: what they set, what wins over them, and what is written of them.
#include "solver/scene/readings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/source_tree.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> shipped{"sandwich.toml", "slab.toml", "pack.toml",
                                       "random_pack.toml"};

Scene scene_of(const std::string& name, const std::vector<std::string>& overrides) {
    return read_scene(source_path("cases/scenes") / name, overrides);
}

Scene sandwich(const std::vector<std::string>& overrides) {
    return scene_of("sandwich.toml", overrides);
}

TEST(Readings, EveryShippedSceneNamesOneAndItIsTheDefault) {
    for (const std::string& name : shipped) {
        const std::string named = to_toml(scene_of(name, {}));
        EXPECT_THAT(named, HasSubstr("readings = \"paper\""));
        EXPECT_EQ(named, to_toml(scene_of(name, {"numerics.readings="}))) << name;
        EXPECT_THAT(to_toml(scene_of(name, {"numerics.readings=consistent"})),
                    HasSubstr("readings = \"consistent\""))
            << name;
    }
}

TEST(Readings, PaperIsThePlainData) {
    const Numerics plain;
    Numerics numerics;
    apply(Readings::paper, Physics(), numerics);
    EXPECT_EQ(numerics.thermal_stress, plain.thermal_stress);
    EXPECT_EQ(numerics.stress_work, plain.stress_work);
    EXPECT_EQ(numerics.heat_capacity, plain.heat_capacity);
    EXPECT_EQ(numerics.surface_motion, plain.surface_motion);
}

TEST(Readings, ConsistentCountsTheHeatOfExpansionOnce) {
    EXPECT_EQ(to_toml(sandwich({"numerics.readings=consistent"})),
              to_toml(sandwich({"numerics.heat_capacity=c_v"})))
        << "one physics is one scene";
    const Scene rigid = sandwich(
        {"numerics.readings=consistent", "physics.mechanics=false", "physics.reference_map="});
    EXPECT_EQ(rigid.numerics.heat_capacity, HeatCapacity::constant_pressure)
        << "in a rigid conductor nothing takes the difference";
}

TEST(Readings, ASingleKeyWins) {
    const Scene scene = sandwich({"numerics.readings=consistent", "numerics.heat_capacity=c_p",
                                  "numerics.thermal_stress=alpha K"});
    EXPECT_EQ(scene.numerics.heat_capacity, HeatCapacity::constant_pressure);
    EXPECT_EQ(scene.numerics.thermal_stress, ThermalStress::alpha_bulk);
    EXPECT_EQ(scene.numerics.stress_work, ThermalStress::alpha_bulk) << "follows thermal_stress";
    EXPECT_THAT(to_toml(scene), Not(HasSubstr("readings"))) << "it is neither";
}

TEST(Readings, WhatIsWrittenIsReadBack) {
    for (const std::vector<std::string>& overrides :
         {std::vector<std::string>{"numerics.readings=consistent"},
          {"numerics.readings=consistent", "physics.mechanics=false", "physics.reference_map="},
          {"numerics.readings=consistent", "numerics.surface_motion=burning with material"}}) {
        const std::string text = to_toml(sandwich(overrides));
        EXPECT_EQ(to_toml(parse_scene(text)), text);
    }
}

}  // namespace
}  // namespace crawford
