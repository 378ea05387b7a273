// Presets in the scene's own measures.
#include "solver/run/preset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "solver/scene/read_scene.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Preset preset(const std::string& name) {
    return read_preset(source_path("cases/scenes/presets/" + name + ".toml"));
}

Scene scene(const std::string& file, const std::vector<std::string>& changes = {}) {
    return read_scene(source_path("cases/scenes/" + file), changes);
}

double chosen(const std::string& key, const Chosen& chosen) {
    for (const std::string& one : chosen.keys)
        if (one.starts_with(key + '=')) return std::stod(one.substr(key.size() + 1));
    return 0.0;
}

TEST(Preset, TakesMoreRowsAndColumnsWhereTheLayerIsThinner) {
    const Chosen usual = choose(preset("paper"), scene("sandwich.toml"));
    const Chosen hot =
        choose(preset("paper"),
               scene("sandwich.toml",
                     {"surface.heat_flux={AP=\"400 cal/(s cm2)\", binder=\"320 cal/(s cm2)\"}"}));
    // Twice the flux burns nearly twice as fast: half the layer D/r_b.
    EXPECT_NEAR(chosen("domain.ny", hot) / chosen("domain.ny", usual), 1.8, 0.3);
    EXPECT_GT(chosen("domain.nx", hot), chosen("domain.nx", usual));
    EXPECT_GT(hot.seconds, usual.seconds);
}

TEST(Preset, PutsTheSidesOfAStripOnNodes) {
    for (const double strip : {40.0, 60.0, 80.0, 120.0}) {
        const Scene wide =
            scene("sandwich.toml", {"morphology.strip=" + std::to_string(strip) + " um"});
        const double nx = chosen("domain.nx", choose(preset("draft"), wide));
        const double cells = 0.5 * strip / 240.0 * nx;
        EXPECT_NEAR(cells, std::round(cells), 1e-6) << strip;
    }
}

TEST(Preset, SaysWhereItWasNotMeasured) {
    EXPECT_THAT(choose(preset("draft"), scene("pack.toml")).outside, IsEmpty());
    const Scene hot =
        scene("slab.toml", {"physics.regression=pyrolysis", "surface.heat_flux=2000 cal/(s cm2)"});
    EXPECT_THAT(choose(preset("draft"), hot).outside, Not(IsEmpty()));
}

TEST(Preset, IsRefusedWhereThereIsNoRateToPromise) {
    EXPECT_THROW(choose(preset("draft"), scene("slab.toml")), InputError);
    EXPECT_THROW(choose(preset("draft"),
                        scene("sandwich.toml", {"physics.regression=none", "time.until_steady="})),
                 InputError);
}

class PresetFile : public OutputTest {};

TEST_F(PresetFile, IsRefusedIfAKeyIsMissingOrUnknown) {
    const std::string whole = content(source_path("cases/scenes/presets/draft.toml"));
    const auto file = directory / "mine.toml";
    put(file, whole + "more = 1\n");
    EXPECT_THROW(read_preset(file), InputError);
    put(file, whole.substr(whole.find('\n', whole.find("error"))));
    EXPECT_THAT(message_of<InputError>([&] { read_preset(file); }), HasSubstr("error is no"));
    put(file, "[");
    EXPECT_THROW(read_preset(file), InputError);
}

TEST(Coarser, HalvesColumnsRowsAndLengthensSteps) {
    const Scene fine = scene("sandwich.toml");
    const Scene coarse = coarser(fine);
    EXPECT_EQ(coarse.domain.nx, 32);
    EXPECT_EQ(coarse.domain.ny, 48);
    EXPECT_EQ(coarse.time.step, 2.0 * fine.time.step);
    const Scene chosen_steps = coarser(scene("sandwich.toml", {"time.step=auto"}));
    EXPECT_EQ(chosen_steps.time.accuracy, 4e-3);
}

}  // namespace
}  // namespace crawford
