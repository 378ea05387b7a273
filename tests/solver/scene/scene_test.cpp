// What the scene reader accepts becomes the right numbers.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/source_tree.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/scene/write_scene.hpp"
#include "tests/solver/scene/scene_text.hpp"

namespace crawford {

namespace {

using testing::discs;
using testing::replaced;
using testing::sandwich_toml;
using testing::ScratchFile;
using testing::with;

Scene scene_of_file(const std::string& name) {
    return read_scene(source_path(std::filesystem::path("cases/scenes") / name));
}

TEST(Scene, ConvertsQuantitiesToSi) {
    const Scene scene = parse_scene(sandwich_toml);
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
    const Scene read = parse_scene(sandwich_toml);
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
    const Scene scene = parse_scene(sandwich_toml + hmx, ".",
                                    {"morphology.outer=HMX", "surface.heat_flux=1 MW/m2"});
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
    const std::string no_flux = replaced(sandwich_toml, "heat_flux =", "# heat_flux =");
    EXPECT_NO_THROW(parse_scene(no_flux, ".", {"physics.heat=false", "physics.regression=none"}));
    const std::string no_pressure = replaced(sandwich_toml, "pressure =", "# pressure =");
    EXPECT_NO_THROW(parse_scene(no_pressure, ".", {"physics.mechanics=false"}));
}

TEST(Scene, ReadsDiscsFromATable) {
    const ScratchFile table(
        "discs.csv", "radius [mm], x [um],y [m]\n# two\n0.04,50,-5e-5\n\n0.03,150,-6e-5\r\n");
    const Scene scene =
        parse_scene(sandwich_toml, table.path().parent_path(),
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
        parse_scene(sandwich_toml, table.path().parent_path(),
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

}  // namespace

}  // namespace crawford
