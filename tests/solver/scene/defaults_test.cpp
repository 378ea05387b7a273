// What follows from other keys is in the scene before it is burnt.
#include "solver/scene/defaults.hpp"

#include <gtest/gtest.h>

#include "solver/scene/write_scene.hpp"
#include "solver/step/simulation.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {

namespace {

TEST(Defaults, ViscousTimeIsThatOfACornerWhereOneBurns) {
    const Scene sandwich = testing::sandwich(16, 24);
    EXPECT_EQ(viscous_time(sandwich), viscous_time_at_a_corner);
    EXPECT_EQ(viscous_time(testing::mechanical_only(sandwich)), 0.0);
    EXPECT_EQ(viscous_time(testing::slab(ammonium_perchlorate(), 16)), 0.0);
}

TEST(Defaults, WhatIsGivenStays) {
    Scene scene = testing::sandwich(16, 24);
    scene.numerics.viscous_time = 0.0;
    EXPECT_EQ(resolved(scene).numerics.viscous_time, 0.0);
}

TEST(Defaults, ASimulationSaysWhatItUses) {
    const Simulation simulation(testing::sandwich(16, 24));
    EXPECT_EQ(simulation.scene().numerics.viscous_time, viscous_time_at_a_corner);
    EXPECT_NE(to_toml(testing::sandwich(16, 24)).find("viscous_time = \"0.0005 s\""),
              std::string::npos);
}

}  // namespace

}  // namespace crawford
