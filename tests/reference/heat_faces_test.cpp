/// The common face of a truth of heat tells what its class tells, bit for bit and under the right name.
#include <gtest/gtest.h>

#include <vector>

#include "reference/adiabatic_column.hpp"
#include "reference/conducting_inclusion.hpp"
#include "reference/manufactured_heat.hpp"
#include "reference/slab_shooting.hpp"
#include "reference/slab_small_strain.hpp"
#include "reference/thermal_laminate.hpp"
#include "reference/travelling_layer.hpp"
#include "tests/reference/truth_at.hpp"

namespace crawford::reference {

namespace {

constexpr double paper_flux = 200.0 * calorie_per_second_per_cm2;

SlabConditions paper_slab() {
    return {.material = ap(),
            .heat_flux = paper_flux,
            .burn_rate = 0.0045,
            .pressure = 2e6,
            .cold_temperature = 300.0};
}

TEST(HeatFaces, Shooting) {
    SlabConditions conditions = paper_slab();
    conditions.regression = Regression::pyrolysis;
    conditions.heat_capacity = HeatCapacity::constant_volume;
    const SlabShooting shot(conditions);
    const ShotState state = shot.states(std::vector{y}).front();
    const At at("slab-shooting", {{"regression", "pyrolysis"}, {"heat_capacity", "c_v"}});
    EXPECT_EQ(at("temperature"), state.temperature);
    EXPECT_EQ(at("velocity_y"), state.velocity);
    EXPECT_EQ(at("stress_xx"), state.stress_11);
    EXPECT_EQ(at("surface_temperature"), shot.surface_temperature());
    EXPECT_EQ(at("burn_rate"), shot.burn_rate());
}

TEST(HeatFaces, SmallStrain) {
    EXPECT_EQ(At("slab-small-strain")("surface_temperature_per_theta"),
              small_strain_sensitivity(paper_slab()));
}

TEST(HeatFaces, AdiabaticColumn) {
    const Material m = ap();
    const double beta = 3.0 * m.thermal_expansion * m.bulk_modulus;
    const AdiabaticColumn column({.capacity = m.density * m.specific_heat,
                                  .capacity_slope = beta * beta / m.bulk_modulus,
                                  .stress_work = beta,
                                  .thermal_stress = beta / 3.0,
                                  .lame = m.lame(),
                                  .shear_modulus = m.shear_modulus,
                                  .cold_temperature = 300.0});
    const Parameters readings{{"heat_capacity", "c_v"}, {"thermal_stress", "alpha K"}};
    Parameters heat = readings;
    heat["heat"] = 4e8;
    const At heated("adiabatic-column", heat);
    EXPECT_DOUBLE_EQ(heated("temperature"), column.heated(4e8));
    EXPECT_EQ(heated("stress_yy"), 0.0);
    Parameters load = readings;
    load["load"] = "pressure";
    load["pressure"] = 3e6;
    const At pressed("adiabatic-column", load);
    const double hot = column.pressed(3e6);
    EXPECT_DOUBLE_EQ(pressed("temperature"), hot);
    EXPECT_DOUBLE_EQ(pressed("stress_xx"), column.lateral_stress(hot, 3e6));
    EXPECT_EQ(pressed("stress_zz"), pressed("stress_xx"));
    EXPECT_EQ(pressed("stress_yy"), -3e6);
}

TEST(HeatFaces, TravellingLayer) {
    const Material m = ap();
    const TravellingLayer layer({.conductivity = m.thermal_conductivity,
                                 .capacity = m.density * m.specific_heat,
                                 .regression_rate = 0.0045,
                                 .flux = paper_flux + m.heat_of_reaction * m.density * 0.0045,
                                 .cold_temperature = 300.0});
    EXPECT_EQ(At("travelling-layer")("temperature"), layer.steady(y, 480e-6));
    EXPECT_EQ(At("travelling-layer", {{"state", "heating"}})("temperature"), layer.heating(y, t));
}

TEST(HeatFaces, ThermalLaminate) {
    const ThermalLaminate laminate({.inner_conductivity = binder().thermal_conductivity,
                                    .outer_conductivity = ap().thermal_conductivity,
                                    .inner_capacity = binder().density * binder().specific_heat,
                                    .outer_capacity = ap().density * ap().specific_heat,
                                    .strip = 50e-6,
                                    .width = 240e-6,
                                    .depth = 240e-6,
                                    .cold_temperature = 300.0,
                                    .rise = 250.0,
                                    .frequency = 500.0});
    const At at("thermal-laminate", {{"strip", 50e-6}, {"rise", 250.0}});
    EXPECT_EQ(at("temperature"), laminate.temperature(x, y, t));
    EXPECT_EQ(at("heat_source"), laminate.source(x, y, t));
    EXPECT_EQ(at("surface_heat_flux_further"), laminate.further_flux(x, t));
    EXPECT_EQ(at("surface_heat_flux"), laminate.outer_flux() + laminate.further_flux(x, t));
    EXPECT_EQ(at("interface_heat_flux"), laminate.crossing_heat(y, t));
}

TEST(HeatFaces, ConductingInclusion) {
    const ConductingInclusion disc({.inner_conductivity = binder().thermal_conductivity,
                                    .outer_conductivity = ap().thermal_conductivity,
                                    .radius = 30e-6,
                                    .temperature = 400.0,
                                    .gradient_x = 1e6,
                                    .gradient_y = 7e5,
                                    .whole = 50e-6,
                                    .gone = 115e-6});
    const At at("conducting-inclusion", {{"radius", 30e-6}, {"gradient_y", 7e5}, {"whole", 50e-6}});
    EXPECT_EQ(at("temperature"), disc.temperature(x, y));
    EXPECT_EQ(at("heat_source"), disc.source(x, y));
}

TEST(HeatFaces, ManufacturedHeat) {
    const ManufacturedHeat heat({.conductivity = ap().thermal_conductivity,
                                 .capacity = ap().density * ap().specific_heat,
                                 .stress_work = 1e5,
                                 .capacity_slope = 10.0,
                                 .width = 240e-6,
                                 .depth = 200e-6,
                                 .cold_temperature = 300.0,
                                 .rise = 300.0,
                                 .frequency = 500.0,
                                 .surface_wave = 12e-6,
                                 .regression_rate = 0.0045,
                                 .speed = 0.002});
    const At at(
        "manufactured-heat",
        {{"stress_work", 1e5}, {"capacity_slope", 10.0}, {"depth", 200e-6}, {"speed", 0.002}});
    EXPECT_EQ(at("surface"), heat.surface(x, t));
    EXPECT_EQ(at("surface_rate"), heat.surface_rate(x, t));
    EXPECT_EQ(at("temperature"), heat.temperature(x, y, t));
    EXPECT_EQ(at("temperature_rate"), heat.material_rate(x, y, t));
    EXPECT_EQ(at("velocity_x"), heat.velocity(x, y, t)[0]);
    EXPECT_EQ(at("velocity_y"), heat.velocity(x, y, t)[1]);
    EXPECT_EQ(at("velocity_divergence"), heat.divergence(x, y, t));
    EXPECT_EQ(at("heat_source"), heat.source(x, y, t));
    EXPECT_EQ(at("surface_heat_flux"), heat.surface_flux(x, t));
}

}  // namespace

}  // namespace crawford::reference
