// The scene reader: what it accepts becomes the right numbers, what it refuses is refused in one
// line that helps.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

const std::string sandwich = R"toml(title = "a sandwich"
[domain]
width = "240 um"
depth = "480 um"
nx = 64
ny = 96
[morphology]
kind = "sandwich"
strip = "60 um"
[surface]
pressure = "2 MPa"
heat_flux = { AP = "200 cal/(s cm2)", binder = "160 cal/(s cm2)" }
[time]
step = "20 us"
end = "0.1 s"
)toml";

Scene with(const std::vector<std::string>& overrides) {
    return parse_scene(sandwich, ".", overrides);
}

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

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

/// A file in a folder of its own, removed with it.
class ScratchFile {
public:
    ScratchFile(const std::string& name, const std::string& content)
        : path_(scratch_.path() / name) {
        std::ofstream(path_) << content;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    Scratch scratch_;
    std::filesystem::path path_;
};

const std::vector<std::string> discs{
    "morphology={kind='discs', particle='AP', matrix='binder', "
    "period='480 um', discs=[{x='50 um', y='-50 um', radius='40 um'}, "
    "{x='150 um', y='-60 um', radius='30 um'}]}"};

Scene scene_of_file(const std::string& name) {
    return read_scene(source_path(std::filesystem::path("cases/scenes") / name));
}

}  // namespace

// ---- what is accepted

TEST(Scene, ConvertsQuantitiesToSi) {
    const Scene scene = parse_scene(sandwich);
    EXPECT_EQ(scene.title, "a sandwich");
    EXPECT_DOUBLE_EQ(scene.domain.width, 240e-6);
    EXPECT_DOUBLE_EQ(scene.domain.depth, 480e-6);
    EXPECT_EQ(scene.domain.nx, 64);
    EXPECT_DOUBLE_EQ(std::get<Sandwich>(scene.morphology.shape).strip, 60e-6);
    EXPECT_DOUBLE_EQ(scene.surface.pressure, 2e6);
    EXPECT_DOUBLE_EQ(scene.surface.heat_flux.at(0), 8.368e6);   // 200 x 4.184 J/(s 1e-4 m2)
    EXPECT_DOUBLE_EQ(scene.surface.heat_flux.at(1), 6.6944e6);  // 160
    EXPECT_DOUBLE_EQ(scene.time.step, 20e-6);
}

TEST(Scene, AnEmptyOverrideRemovesAKey) {
    const Scene scene = with({"domain.clustering=1.0", "domain.clustering="});
    EXPECT_EQ(scene.domain.clustering, Scene().domain.clustering);
}

TEST(Scene, DefaultsAreThoseOfThePlainData) {
    const Scene read = parse_scene(sandwich);
    const Scene plain;
    EXPECT_EQ(read.numerics.element, plain.numerics.element);
    EXPECT_EQ(read.numerics.cut_cell_conductivity, plain.numerics.cut_cell_conductivity);
    EXPECT_EQ(read.morphology.indicator, plain.morphology.indicator);
    EXPECT_EQ(read.domain.clustering, plain.domain.clustering);
    EXPECT_EQ(read.bottom.temperature, plain.bottom.temperature);
    EXPECT_EQ(read.morphology.materials.at(0).name, "AP");
    EXPECT_EQ(read.morphology.materials.at(1).name, "binder");
    EXPECT_FALSE(read.time.until_steady.has_value());
    EXPECT_FALSE(read.output.snapshots_every.has_value());
}

TEST(Scene, OneFluxForAllMaterials) {
    const Scene scene = with({"surface.heat_flux=5 MW/m2"});
    EXPECT_EQ(scene.surface.heat_flux, (std::vector<double>{5e6, 5e6}));
}

TEST(Scene, FluxesFollowTheOrderOfTheMaterials) {
    const Scene scene = with({"morphology.inner=AP", "morphology.outer=binder"});
    EXPECT_EQ(scene.morphology.materials.at(0).name, "binder");
    EXPECT_DOUBLE_EQ(scene.surface.heat_flux.at(0), 6.6944e6);
    EXPECT_DOUBLE_EQ(scene.surface.heat_flux.at(1), 8.368e6);
}

TEST(Scene, OverridesAPropertyOfABuiltInMaterial) {
    const Scene scene = with({"materials.binder.shear_modulus=5 MPa"});
    EXPECT_DOUBLE_EQ(scene.morphology.materials.at(1).shear_modulus, 5e6);
    EXPECT_DOUBLE_EQ(scene.morphology.materials.at(1).density, htpb_binder().density);
}

TEST(Scene, TakesANewMaterialAndANegativeLame) {
    const std::string hmx = R"toml([materials.HMX]
thermal_conductivity = "0.4 W/(m K)"
specific_heat = "0.3 kcal/(kg K)"
density = "1.9 g/cm3"
bulk_modulus = "10 GPa"
shear_modulus = "16 GPa"
thermal_expansion = "1e-5 1/K"
pyrolysis_prefactor = "145000 cm/s"
activation_temperature = "11000 K"
heat_of_reaction = "-47 kcal/kg"
)toml";
    const Scene scene =
        parse_scene(sandwich + hmx, ".", {"morphology.outer=HMX", "surface.heat_flux=1 MW/m2"});
    const Material& material = scene.morphology.materials.at(0);
    EXPECT_EQ(material.name, "HMX");
    EXPECT_DOUBLE_EQ(material.density, 1900.0);
    EXPECT_DOUBLE_EQ(material.pyrolysis_prefactor, 1450.0);
    EXPECT_DOUBLE_EQ(material.heat_of_reaction, -47.0 * 4184.0);
    EXPECT_LT(material.lame(), 0.0);  // admissible: K > 0 and mu > 0 are enough for a stable solid
}

TEST(Scene, ReadsEveryWordOfNumerics) {
    const Scene scene =
        with({"numerics.element=q1", "numerics.solver=pcg", "numerics.solver_tolerance=1e-6",
              "numerics.heat_tolerance=1e-9", "numerics.coupling=lagged",
              "numerics.thermal_stress=alpha K", "numerics.heat_capacity=c_v",
              "numerics.surface_motion=burning with material", "numerics.strain_norm=largest",
              "numerics.viscous_time=0.5 ms", "surface.traction=vertical", "bottom.support=clamped",
              "time.until_steady=1e-6", "time.scheme=bdf2", "output.history_every=10",
              "domain.half=true", "morphology.indicator=reference map",
              "numerics.cut_cell_conductivity=harmonic", "numerics.cut_cell_moduli=arithmetic"});
    EXPECT_EQ(scene.numerics.element, Element::q1);
    EXPECT_EQ(scene.numerics.solver, LinearSolver::pcg);
    EXPECT_EQ(scene.numerics.solver_tolerance, 1e-6);
    EXPECT_EQ(scene.numerics.heat_tolerance, 1e-9);
    EXPECT_EQ(scene.numerics.coupling, Coupling::lagged);
    EXPECT_EQ(scene.numerics.thermal_stress, ThermalStress::alpha_bulk);
    EXPECT_EQ(scene.numerics.stress_work, ThermalStress::alpha_bulk) << "follows thermal_stress";
    EXPECT_EQ(scene.numerics.heat_capacity, HeatCapacity::constant_volume);
    EXPECT_EQ(scene.numerics.surface_motion, SurfaceMotion::burning_with_material);
    EXPECT_EQ(scene.numerics.strain_norm, StrainNorm::largest_component);
    EXPECT_DOUBLE_EQ(scene.numerics.viscous_time.value(), 5e-4);
    EXPECT_EQ(scene.surface.traction, Traction::vertical);
    EXPECT_EQ(scene.bottom.support, Support::clamped);
    EXPECT_EQ(scene.time.until_steady, 1e-6);
    EXPECT_EQ(scene.time.scheme, Stepping::bdf2);
    EXPECT_EQ(scene.output.history_every, 10);
    EXPECT_TRUE(scene.domain.half);
    EXPECT_EQ(scene.morphology.indicator, Indicator::reference_map);
    EXPECT_EQ(scene.numerics.cut_cell_conductivity, CutConductivity::harmonic);
    EXPECT_EQ(scene.numerics.cut_cell_moduli, CutModuli::arithmetic);
}

TEST(Scene, StressWorkMayDifferFromThermalStress) {
    const Scene scene = with({"numerics.stress_work=alpha K"});
    EXPECT_EQ(scene.numerics.thermal_stress, ThermalStress::three_alpha_bulk);
    EXPECT_EQ(scene.numerics.stress_work, ThermalStress::alpha_bulk);
}

TEST(Scene, ReferenceMapFollowsMechanics) {
    EXPECT_FALSE(with({"physics.mechanics=false"}).physics.reference_map);
    EXPECT_TRUE(with({}).physics.reference_map);
}

TEST(Scene, WhatIsNotComputedNeedsNoValue) {
    const std::string no_flux = replaced(sandwich, "heat_flux =", "# heat_flux =");
    EXPECT_NO_THROW(parse_scene(no_flux, ".", {"physics.heat=false", "physics.regression=none"}));
    const std::string no_pressure = replaced(sandwich, "pressure =", "# pressure =");
    EXPECT_NO_THROW(parse_scene(no_pressure, ".", {"physics.mechanics=false"}));
}

TEST(Scene, ReadsDiscsFromATable) {
    const ScratchFile table(
        "discs.csv", "radius [mm], x [um],y [m]\n# two\n0.04,50,-5e-5\n\n0.03,150,-6e-5\r\n");
    const Scene scene =
        parse_scene(sandwich, table.path().parent_path(),
                    {"morphology={kind='discs', file='" + table.path().filename().string() + "'}"});
    const auto& shape = std::get<Discs>(scene.morphology.shape);
    ASSERT_EQ(shape.discs.size(), 2u);
    EXPECT_DOUBLE_EQ(shape.discs[0].radius, 40e-6);
    EXPECT_DOUBLE_EQ(shape.discs[1].x, 150e-6);
    EXPECT_DOUBLE_EQ(shape.discs[1].y, -60e-6);
    EXPECT_DOUBLE_EQ(shape.period, scene.domain.depth) << "the default period";
}

TEST(Scene, ReadsATableThatASpreadsheetHasWritten) {
    const ScratchFile table(
        "discs.csv", "\xEF\xBB\xBF\"x [um]\",\"y [um]\",\"radius [um]\"\r\n\"50\",-50,\"40\"\r\n");
    const Scene scene =
        parse_scene(sandwich, table.path().parent_path(),
                    {"morphology={kind='discs', file='" + table.path().filename().string() + "'}"});
    const auto& shape = std::get<Discs>(scene.morphology.shape);
    ASSERT_EQ(shape.discs.size(), 1u);
    EXPECT_DOUBLE_EQ(shape.discs[0].x, 50e-6);
    EXPECT_DOUBLE_EQ(shape.discs[0].radius, 40e-6);
}

TEST(Scene, TextOfASceneGivesTheSceneBack) {
    const std::vector<std::vector<std::string>> variants{
        {},
        {"domain.half=true", "time.until_steady=1e-6", "output.snapshots_every=5 ms"},
        {"morphology.indicator=reference map", "numerics.cut_cell_conductivity=arithmetic"},
        {"morphology={kind='uniform', material='binder'}", "domain.nx=1", "domain.width=5 um"},
        {"physics.regression=fixed", "surface.burn_rate=0.45 cm/s", "title=say \"a\\b\""},
        discs};
    for (const auto& overrides : variants) {
        const std::string text = to_toml(with(overrides));
        EXPECT_EQ(to_toml(parse_scene(text)), text);
    }
    EXPECT_NE(to_toml(with({})), to_toml(with({"surface.pressure=2.0000000001 MPa"})));
}

TEST(Scene, ShippedScenesAreSound) {
    const Scene burning = scene_of_file("sandwich.toml");
    EXPECT_TRUE(burning.domain.half);
    EXPECT_EQ(burning.domain.ny, 96);
    const Scene slab = scene_of_file("slab.toml");
    EXPECT_EQ(slab.domain.nx, 1);
    EXPECT_EQ(slab.morphology.materials.at(0).heat_of_reaction, 0.0);
    EXPECT_DOUBLE_EQ(slab.surface.burn_rate, 4.5e-3);
    const Scene pack = scene_of_file("pack.toml");
    const auto& shape = std::get<Discs>(pack.morphology.shape);
    ASSERT_EQ(shape.discs.size(), 40u);
    double area = 0.0;
    for (const Disc& disc : shape.discs) area += 3.14159265358979 * disc.radius * disc.radius;
    EXPECT_NEAR(area / (pack.domain.width * shape.period), 0.72, 5e-4);  // the paper's 72 %
}

TEST(Scene, ShippedPackKeepsAGapOfThreeMicrometres) {
    // One and a half cells of 2 um: the discs grown by half of it must not overlap, images
    // included.
    Scene pack = scene_of_file("pack.toml");
    for (Disc& disc : std::get<Discs>(pack.morphology.shape).discs) disc.radius += 1.5e-6;
    EXPECT_NO_THROW(check(pack));
}

// ---- what is refused: the file

TEST(SceneRefuses, AFileThatIsNotThere) {
    const std::string message = refusal_of([] { read_scene("nowhere/missing.toml"); });
    EXPECT_NE(message.find("nowhere/missing.toml"), std::string::npos) << message;
    EXPECT_NE(refusal_of([] { read_scene("."); }).find("cannot be opened"), std::string::npos);
}

TEST(SceneRefuses, BrokenTomlWithItsLine) {
    expect_text_refused(replaced(sandwich, "nx = 64", "nx = = 64"), {"scene:5:", "TOML"});
}

TEST(SceneRefuses, SaysTheLineOfAWrongValue) {
    expect_text_refused(replaced(sandwich, "\"2 MPa\"", "\"2 K\""),
                        {"scene:11:", "surface.pressure", "\"2 K\"", "wrong dimension", "Pa"});
}

// ---- keys

TEST(SceneRefuses, UnknownKeysWithTheNearestName) {
    expect_text_refused(replaced(sandwich, "width =", "widht ="),
                        {"scene:3:", "domain.widht", "did you mean width?"});
    expect_text_refused(replaced(sandwich, "[surface]", "[surfaces]"), {"did you mean surface?"});
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
    expect_text_refused(replaced(sandwich, "ny = 96\n", ""), {"domain.ny is missing"});
    expect_text_refused(replaced(sandwich, "kind = \"sandwich\"\nstrip = \"60 um\"\n", ""),
                        {"morphology.kind is missing"});
    expect_text_refused(replaced(sandwich, "strip = \"60 um\"\n", ""),
                        {"morphology.strip is missing"});
    expect_text_refused(replaced(sandwich, "[time]\nstep = \"20 us\"\nend = \"0.1 s\"\n", ""),
                        {"time.step, time.end are missing"});
    expect_text_refused(replaced(sandwich, "heat_flux =", "# heat_flux ="),
                        {"surface.heat_flux is missing", "physics.heat = true"});
    expect_text_refused(replaced(sandwich, ", binder = \"160 cal/(s cm2)\"", ""),
                        {"surface.heat_flux.binder is missing"});
    expect_text_refused(replaced(sandwich, "pressure =", "# pressure ="),
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
                sandwich, table.path().parent_path(),
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

}  // namespace crawford
