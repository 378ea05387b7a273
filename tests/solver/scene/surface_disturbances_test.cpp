// A flame that swings and a surface that starts as a ripple: read, written, refused, and what they do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "solver/burning/flux_modulation.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using testing::HasSubstr;

const std::string sandwich = R"toml(
[domain]
width = "240 um"
depth = "240 um"
nx = 16
ny = 16
[morphology]
kind = "sandwich"
strip = "60 um"
[physics]
mechanics = false
[surface]
heat_flux = { AP = "200 cal/(s cm2)", binder = "160 cal/(s cm2)" }
[time]
step = "20 us"
end = "0.1 s"
)toml";

Scene with(const std::vector<std::string>& overrides) {
    return parse_scene(sandwich, ".", overrides);
}

std::string refusal_of(const std::vector<std::string>& overrides) {
    try {
        with(overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

const std::string swinging = "surface.modulation={ amplitude = 0.01, frequency = \"0.2 kHz\" }";
const std::string rippled = "surface.ripple={ amplitude = \"0.1 um\", waves = 2 }";

TEST(SurfaceDisturbances, AreReadAndWritten) {
    for (const Scene& scene :
         {with({swinging, rippled}), parse_scene(to_toml(with({swinging, rippled})))}) {
        ASSERT_TRUE(scene.surface.modulation);
        EXPECT_EQ(scene.surface.modulation->amplitude, 0.01);
        EXPECT_DOUBLE_EQ(scene.surface.modulation->frequency, 200.0);
        ASSERT_TRUE(scene.surface.ripple);
        EXPECT_DOUBLE_EQ(scene.surface.ripple->amplitude, 1e-7);
        EXPECT_EQ(scene.surface.ripple->waves, 2);
    }
    EXPECT_FALSE(with({}).surface.modulation);
    EXPECT_FALSE(with({}).surface.ripple);
    EXPECT_EQ(with({"surface.ripple.amplitude=1 um"}).surface.ripple->waves, 1);
}

TEST(SurfaceDisturbances, AreRefusedByNameValueAndLimit) {
    EXPECT_THAT(refusal_of({"surface.modulation.amplitude=0.1"}), HasSubstr("frequency"));
    EXPECT_THAT(refusal_of({"surface.ripple.waves=1"}), HasSubstr("amplitude"));
    EXPECT_THAT(refusal_of({"surface.modulation=0.1"}), HasSubstr("a table"));
    EXPECT_THAT(refusal_of({swinging, "surface.modulation.amplitude=1.5"}), HasSubstr("1.5"));
    EXPECT_THAT(refusal_of({swinging, "surface.modulation.phase=1"}),
                HasSubstr("modulation.phase"));
    EXPECT_THAT(refusal_of({swinging, "surface.modulation.frequency=200 s"}), HasSubstr("Hz"));
    EXPECT_THAT(refusal_of({swinging, "surface.modulation.frequency=20 kHz"}),
                HasSubstr("20000 Hz leaves 2.5 steps a period; the limit is 4"));
    EXPECT_THAT(refusal_of({swinging, "time.until_steady=1e-4"}), HasSubstr("until_steady"));
    EXPECT_THAT(refusal_of({swinging, "physics.heat=false", "physics.regression=\"fixed\"",
                            "surface.burn_rate=1 mm/s"}),
                HasSubstr("physics.heat"));
    EXPECT_THAT(refusal_of({rippled, "surface.ripple.waves=5"}), HasSubstr("3.2 cells a wave"));
    EXPECT_THAT(refusal_of({rippled, "surface.ripple.amplitude=60 um"}), HasSubstr("slope 3.14"));
    EXPECT_THAT(refusal_of({rippled, "surface.ripple.waves=1", "surface.ripple.amplitude=110 um",
                            "domain.depth=200 um"}),
                HasSubstr("half of domain.depth"));
}

TEST(SurfaceDisturbances, AFlameSwingsInEveryMaterial) {
    const Surface surface = with({swinging}).surface;
    const Surface crest = heated_at(surface, 5e-3);
    const Surface trough = heated_at(surface, 7.5e-3);
    for (size_t k = 0; k < 2; ++k) {
        EXPECT_DOUBLE_EQ(crest.heat_flux[k], 1.01 * surface.heat_flux[k]);
        EXPECT_DOUBLE_EQ(trough.heat_flux[k], 0.99 * surface.heat_flux[k]);
    }
    EXPECT_EQ(heated_at(with({}).surface, 1.0).heat_flux, with({}).surface.heat_flux);
}

/// The surface temperature above the cold after one step, over that of a steady flame.
double first_step(const std::string& scheme) {
    // A quarter of a period is the step: cos is 0 at its end, 1/sqrt 2 at its middle.
    const std::string quarter = "surface.modulation={ amplitude = 1.0, frequency = \"12.5 kHz\" }";
    const auto rise = [&](std::vector<std::string> overrides) {
        overrides.push_back("time.scheme=" + scheme);
        Simulation simulation(with(overrides));
        simulation.step(20e-6, 20e-6);
        if (scheme == "bdf2") {  // its first step is the other scheme's
            const State first = simulation.state();
            State start = Simulation(with(overrides)).state();
            start.time = 0.0;
            State before = start;
            before.time = -20e-6;
            start.previous = std::make_shared<const State>(before);
            simulation.restore(start);
            simulation.step(20e-6, 20e-6);
        }
        return simulation.state().temperature(0, 16) - 300.0;
    };
    return rise({quarter}) / rise({});
}

TEST(SurfaceDisturbances, AFlameIsTakenAtTheTimeTheHeatStepIsCentredOn) {
    EXPECT_NEAR(first_step("euler"), 1.0 + std::numbers::sqrt2 / 2.0, 1e-6);
    EXPECT_NEAR(first_step("bdf2"), 1.0, 1e-6);
}

TEST(SurfaceDisturbances, ARippleIsTheStart) {
    for (const bool half : {false, true}) {
        const Simulation simulation(
            with({rippled, half ? "domain.half=true" : "domain.half=false"}));
        const Grid& grid = simulation.grid();
        for (int i = 0; i < grid.node_columns(); ++i)
            EXPECT_NEAR(simulation.state().surface[size_t(i)],
                        1e-7 * std::cos(4.0 * std::numbers::pi * grid.x(i) / 240e-6), 1e-20);
    }
}

TEST(SurfaceDisturbances, ARippleStartsInTheMorphologyThatIsThere) {
    const std::vector<std::string> disc{
        "morphology={ kind = \"discs\", particle = \"AP\", matrix = \"binder\", period = \"240 "
        "um\", "
        "discs = [ { x = \"0 um\", y = \"0 um\", radius = \"40 um\" } ] }"};
    std::vector<std::string> lowered = disc;
    lowered.emplace_back("surface.ripple={ amplitude = \"30 um\" }");
    const Simulation level(with(disc));
    const Simulation rippling(with(lowered));
    EXPECT_NE(level.material_fraction().values(), rippling.material_fraction().values());
}

}  // namespace

}  // namespace crawford
