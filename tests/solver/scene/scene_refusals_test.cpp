// What the scene reader refuses, it refuses in one line that helps.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "tests/solver/scene/scene_text.hpp"

namespace crawford {

namespace {

using testing::discs;
using testing::replaced;
using testing::sandwich_toml;
using testing::ScratchFile;
using testing::with;

/// The message of the InputError that `action` throws; it must be one line.
std::string refusal_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        return message;
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

/// The scene above with `overrides` must be refused, by a message with all of `words`.
void expect_refused(const std::vector<std::string>& overrides,
                    const std::vector<std::string>& words) {
    const std::string message = refusal_of([&] { with(overrides); });
    for (const std::string& word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << "no \"" << word << "\" in: " << message;
    }
}

void expect_text_refused(const std::string& text, const std::vector<std::string>& words) {
    const std::string message = refusal_of([&] { parse_scene(text); });
    for (const std::string& word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << "no \"" << word << "\" in: " << message;
    }
}

// ---- the file

TEST(SceneRefuses, AFileThatIsNotThere) {
    const std::string message = refusal_of([] { read_scene("nowhere/missing.toml"); });
    EXPECT_NE(message.find("nowhere/missing.toml"), std::string::npos) << message;
    EXPECT_NE(refusal_of([] { read_scene("."); }).find("cannot be opened"), std::string::npos);
}

TEST(SceneRefuses, BrokenTomlWithItsLine) {
    expect_text_refused(replaced(sandwich_toml, "nx = 64", "nx = = 64"), {"scene:5:", "TOML"});
}

TEST(SceneRefuses, SaysTheLineOfAWrongValue) {
    expect_text_refused(replaced(sandwich_toml, "\"2 MPa\"", "\"2 K\""),
                        {"scene:11:", "surface.pressure", "\"2 K\"", "wrong dimension", "Pa"});
}

// ---- keys

TEST(SceneRefuses, UnknownKeysWithTheNearestName) {
    expect_text_refused(replaced(sandwich_toml, "width =", "widht ="),
                        {"scene:3:", "domain.widht", "did you mean width?"});
    expect_text_refused(replaced(sandwich_toml, "[surface]", "[surfaces]"),
                        {"did you mean surface?"});
    expect_refused({"numerics.elemnt=q1"}, {"--set", "numerics.elemnt", "did you mean element?"});
    expect_refused({"surface.heat_flux.bindr=1 W/m2"}, {"heat_flux.bindr", "did you mean binder?"});
    expect_refused({"bottom.zzzzzz=1"}, {"bottom.zzzzzz", "known: temperature, support"});
}

TEST(SceneRefuses, UnknownWordsWithTheNearest) {
    expect_refused({"numerics.element=bbra"},
                   {"numerics.element", "bbra", "q1", "did you mean \"bbar\"?"});
    expect_refused({"morphology.kind=packs"},
                   {"morphology.kind", "\"packs\"",
                    "\"uniform\", \"sandwich\", \"discs\", \"pack\"; did you mean"});
}

TEST(SceneRefuses, MissingKeys) {
    expect_text_refused(replaced(sandwich_toml, "ny = 96\n", ""), {"domain.ny is missing"});
    expect_text_refused(replaced(sandwich_toml, "kind = \"sandwich\"\nstrip = \"60 um\"\n", ""),
                        {"morphology.kind is missing"});
    expect_text_refused(replaced(sandwich_toml, "strip = \"60 um\"\n", ""),
                        {"morphology.strip is missing"});
    expect_text_refused(replaced(sandwich_toml, "[time]\nstep = \"20 us\"\nend = \"0.1 s\"\n", ""),
                        {"time.step, time.end are missing"});
    expect_text_refused(replaced(sandwich_toml, "heat_flux =", "# heat_flux ="),
                        {"surface.heat_flux is missing", "physics.heat = true"});
    expect_text_refused(replaced(sandwich_toml, ", binder = \"160 cal/(s cm2)\"", ""),
                        {"surface.heat_flux.binder is missing"});
    expect_text_refused(replaced(sandwich_toml, "pressure =", "# pressure ="),
                        {"surface.pressure is missing"});
    expect_refused({"physics.regression=fixed"}, {"surface.burn_rate is missing"});
}

TEST(SceneRefuses, OverridesThatAreNoAssignment) {
    expect_refused({"surface.pressure"}, {"surface.pressure", "key=value"});
    expect_refused({"=3"}, {"key=value"});
    expect_refused({"title.x=3"}, {"title", "no table"});
    expect_refused({"time.until_steady="}, {"time.until_steady=", "does not give"});
}

// ---- values

TEST(SceneRefuses, WrongTypes) {
    expect_refused({"surface.pressure=2"}, {"surface.pressure = 2", "wrong type", "unit in Pa"});
    expect_refused({"domain.nx=\"64\""}, {"domain.nx", "wrong type", "whole number"});
    expect_refused({"domain.nx=64.5"}, {"domain.nx", "wrong type", "whole number"});
    expect_refused({"physics.heat=\"true\""}, {"physics.heat", "wrong type", "true or false"});
    expect_refused({"domain.clustering=\"2\""}, {"domain.clustering", "wrong type"});
    expect_refused({"domain=3"}, {"domain", "wrong type", "table"});
    expect_refused({"title=3"}, {"title = 3", "wrong type", "string"});
}

TEST(SceneRefuses, WrongDimensionsAndUnits) {
    expect_refused({"surface.pressure=2 K"},
                   {"surface.pressure", "\"2 K\"", "wrong dimension", "Pa"});
    expect_refused({"surface.pressure=\"2\""}, {"surface.pressure", "no unit", "Pa"});
    expect_refused({"surface.pressure=2 MPaa"}, {"MPaa", "unknown", "Pa"});
    expect_refused({"surface.pressure=high"}, {"surface.pressure", "does not begin with a number"});
}

TEST(SceneRefuses, ZeroNegativeAndNotFinite) {
    expect_refused({"domain.width=0 um"}, {"domain.width", "1e-09 m"});
    expect_refused({"domain.depth=-480 um"}, {"domain.depth", "-480 um", "limits"});
    expect_refused({"time.step=0 s"}, {"time.step", "limits"});
    expect_refused({"domain.nx=0"}, {"domain.nx = 0", "from 1"});
    expect_refused({"domain.nx=-4"}, {"domain.nx = -4", "from 1"});
    expect_refused({"domain.ny=3"}, {"domain.ny = 3", "from 4"});
    expect_refused({"surface.pressure=nan MPa"}, {"surface.pressure", "not finite"});
    expect_refused({"surface.pressure=inf Pa"}, {"surface.pressure", "not finite"});
    expect_refused({"surface.pressure=1e999 Pa"}, {"surface.pressure", "too large"});
    expect_refused({"domain.clustering=nan"}, {"domain.clustering", "limits"});
    expect_refused({"materials.AP.bulk_modulus=-1 GPa"}, {"materials.AP.bulk_modulus", "limits"});
    expect_refused({"surface.pressure=-2 MPa"}, {"surface.pressure", "limits"});
}

// ---- materials

TEST(SceneRefuses, MaterialsThatAreNotDefined) {
    expect_refused({"morphology.inner=HMX"},
                   {"morphology.inner", "HMX", "AP, binder", "[materials.HMX]"});
    expect_refused({"morphology.inner=bindr"}, {"did you mean binder?"});
    expect_refused({"materials.HMX.density=1900 kg/m3"},
                   {"materials.HMX.thermal_conductivity", "materials.HMX.heat_of_reaction",
                    "are missing", "all properties"});
    expect_refused({"materials.bindr.density=900 kg/m3"}, {"did you mean binder?"});
    expect_refused({"morphology.inner=AP"}, {"AP twice"});
}

// ---- at odds

TEST(SceneRefuses, AStripThatDoesNotFit) {
    expect_refused({"morphology.strip=300 um"},
                   {"morphology.strip = 300 um", "domain.width = 240 um"});
    expect_refused({"morphology.strip=240 um"}, {"domain.width = 240 um"});
    expect_refused({"morphology.strip=3 um"}, {"thinner than a cell of 3.75 um", "domain.nx"});
    expect_refused({"morphology.strip=238 um"}, {"layer of 2 um"});
    EXPECT_NO_THROW(with({"morphology.strip=3.75 um"})) << "one cell is enough";
}

TEST(SceneRefuses, DiscsThatOverlap) {
    const auto near = [](const std::string& x, const std::string& y) {
        return std::vector<std::string>{
            "morphology={kind='discs', discs=[{x='10 um', y='-10 um', radius='40 um'}, "
            "{x='" +
            x + "', y='" + y + "', radius='30 um'}]}"};
    };
    expect_refused(near("70 um", "-10 um"),
                   {"disc 1 at (10, -10) um", "disc 2 at (70, -10) um", "10 um"});
    expect_refused(near("190 um", "-10 um"), {"periodic images", "overlap by 10 um"});
    expect_refused(near("10 um", "-430 um"), {"periodic images", "overlap by 10 um"});
    EXPECT_NO_THROW(with(near("80 um", "-10 um"))) << "discs may touch";
}

TEST(SceneRefuses, ADiscLargerThanTheDomain) {
    expect_refused({"morphology={kind='discs', discs=[{x='0 um', y='0 um', radius='120 um'}]}"},
                   {"disc 1", "120 um", "width 240 um"});
    expect_refused({"morphology={kind='discs', period='100 um', discs=[{x='0 um', y='0 um', "
                    "radius='60 um'}]}"},
                   {"disc 1", "period 100 um"});
    expect_refused({"morphology={kind='discs', discs=[{x='0 um', y='0 um', radius='0 um'}]}"},
                   {"radius", "limits"});
}

TEST(SceneRefuses, TablesOfDiscsThatAreWrong) {
    const auto refused = [](const std::string& content, const std::string& word) {
        const ScratchFile table("discs.csv", content);
        const std::string message = refusal_of([&] {
            parse_scene(
                sandwich_toml, table.path().parent_path(),
                {"morphology={kind='discs', file='" + table.path().filename().string() + "'}"});
        });
        EXPECT_NE(message.find(word), std::string::npos) << message;
    };
    refused("x,y,radius\n1,1,1\n", "x [um],y [um],radius [um]");
    refused("x [um],y [um],radius [K]\n1,1,1\n", "wrong dimension");
    refused("x [um],y [um],radius [um]\n1,1\n", ":2: has 2 values; expected 3");
    refused("x [um],y [um],radius [um]\n1,1,one\n", ":2:");
    refused("x [um],y [um],radius [um]\n1,1,2 5\n", "\"2 5\" is no number");
    refused("x [um],y [um],radius [um]\n1,1,2 m\n", "\"2 m\" is no number");
    refused("x [um],y [um],radius [2 um]\n1,1,1\n", "more than one number");
    refused("x [um];y [um];radius [um]\n1;1;1\n", ":1: has semicolons");
    refused("x [um]\ty [um]\tradius [um]\n1\t1\t1\n", ":1: has tabs");
    refused("x [um],y [um],x [um]\n1,1,1\n", "twice");
    refused("x [um],y [um],radius [um]\n", "no discs");
    refused("x [um],y [um],radius [um]\n1,1,-3\n", "disc 1");
    expect_refused({"morphology={kind='discs', file='nowhere.csv'}"},
                   {"morphology.file", "nowhere.csv", "cannot be opened"});
}

TEST(SceneRefuses, HalvesOfWhatIsNotSymmetric) {
    expect_refused({"domain.half=true", "domain.nx=65"}, {"domain.nx = 65", "even"});
    expect_refused({discs[0], "domain.half=true"}, {"domain.half", "discs"});
    expect_refused({"domain.nx=2", "morphology.strip=120 um"}, {"domain.nx = 2"});
}

TEST(SceneRefuses, PhysicsThatLacksItsGround) {
    expect_refused({"physics.heat=false"}, {"physics.regression", "pyrolysis", "heat"});
    expect_refused({"physics.mechanics=false", "physics.reference_map=true"},
                   {"physics.reference_map", "mechanics"});
    expect_refused({"morphology.indicator=reference map", "physics.reference_map=false"},
                   {"morphology.indicator = \"reference map\"", "set physics.mechanics",
                    "reference_map = true", "\"laboratory\""});
    expect_refused({"morphology.indicator=reference map", "physics.mechanics=false"},
                   {"morphology.indicator"});
    expect_refused({"morphology={kind='uniform', material='binder', indicator='laboratory'}"},
                   {"morphology.indicator is not a key", "known: kind, material"});
    expect_refused({"numerics.cut_cell_moduli=laminate"},
                   {"numerics.cut_cell_moduli = \"laminate\"", "\"arithmetic\", \"harmonic\""});
    expect_refused({"physics.heat=false", "physics.mechanics=false", "physics.regression=none"},
                   {"asks for nothing"});
    expect_refused({"physics.mechanics=false", "numerics.surface_motion=burning with material"},
                   {"surface_motion", "velocity"});
    expect_refused({"physics.regression=fixed", "surface.burn_rate=0 m/s"},
                   {"surface.burn_rate", "not positive"});
}

TEST(SceneRefuses, TimesOutOfOrder) {
    expect_refused({"time.end=1 us"}, {"time.end", "time.step"});
    expect_refused({"output.snapshots_every=1 us"}, {"output.snapshots_every", "time.step"});
    expect_refused({"physics.regression=none", "time.until_steady=1e-6"},
                   {"time.until_steady", "pyrolysis"});
}

}  // namespace

}  // namespace crawford
