/// The common face of a truth tells what its class tells, bit for bit and under the right name.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reference/adiabatic_column.hpp"
#include "reference/burning_sandwich_front.hpp"
#include "reference/carried_profile.hpp"
#include "reference/conducting_inclusion.hpp"
#include "reference/elastic_sandwich.hpp"
#include "reference/exact_motions.hpp"
#include "reference/faded_inclusion.hpp"
#include "reference/jumping_front.hpp"
#include "reference/manufactured_elastic_body.hpp"
#include "reference/manufactured_elastic_strip.hpp"
#include "reference/manufactured_heat.hpp"
#include "reference/refracted_front.hpp"
#include "reference/regressing_front.hpp"
#include "reference/slab_shooting.hpp"
#include "reference/slab_small_strain.hpp"
#include "reference/thermal_laminate.hpp"
#include "reference/thermal_sandwich.hpp"
#include "reference/travelling_layer.hpp"
#include "reference/truth_registry.hpp"
#include "reference/williams_corner.hpp"

namespace crawford::reference {

namespace {

constexpr double x = 31e-6;
constexpr double y = -47e-6;
constexpr double t = 2e-3;

/// One point of a truth.
class At {
public:
    explicit At(const char* name, const Parameters& given = {})
        : table_(truth(name, given).values(std::vector{Eigen::Vector2d(x, y)}, t)) {}

    double operator()(const char* field) const { return table_.column(field).front(); }

    void expect(const char* vector, const Eigen::Vector2d& wanted) const {
        EXPECT_EQ((*this)((std::string(vector) + "_x").c_str()), wanted.x()) << vector;
        EXPECT_EQ((*this)((std::string(vector) + "_y").c_str()), wanted.y()) << vector;
    }
    void expect_stress(const PlaneStrainStress& wanted) const {
        EXPECT_EQ((*this)("stress_xx"), wanted.xx);
        EXPECT_EQ((*this)("stress_yy"), wanted.yy);
        EXPECT_EQ((*this)("stress_zz"), wanted.zz);
        EXPECT_EQ((*this)("stress_xy"), wanted.xy);
        EXPECT_EQ((*this)("pressure"), wanted.pressure());
    }
    void expect_matrix(const std::string& name, const Eigen::Matrix2d& wanted) const {
        EXPECT_EQ((*this)((name + "_xx").c_str()), wanted(0, 0)) << name;
        EXPECT_EQ((*this)((name + "_xy").c_str()), wanted(0, 1)) << name;
        EXPECT_EQ((*this)((name + "_yx").c_str()), wanted(1, 0)) << name;
        EXPECT_EQ((*this)((name + "_yy").c_str()), wanted(1, 1)) << name;
    }
    void expect_symmetric(const std::string& name, const Eigen::Matrix2d& wanted) const {
        EXPECT_EQ((*this)((name + "_xx").c_str()), wanted(0, 0)) << name;
        EXPECT_EQ((*this)((name + "_yy").c_str()), wanted(1, 1)) << name;
        EXPECT_EQ((*this)((name + "_xy").c_str()), wanted(0, 1)) << name;
    }

private:
    FieldTable table_;
};

constexpr double paper_flux = 200.0 * calorie_per_second_per_cm2;

SlabConditions paper_slab() {
    return {.material = ap(),
            .heat_flux = paper_flux,
            .burn_rate = 0.0045,
            .pressure = 2e6,
            .cold_temperature = 300.0};
}

TEST(TruthFaces, Shooting) {
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

TEST(TruthFaces, SmallStrain) {
    EXPECT_EQ(At("slab-small-strain")("surface_temperature_per_theta"),
              small_strain_sensitivity(paper_slab()));
}

TEST(TruthFaces, AdiabaticColumn) {
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

TEST(TruthFaces, TravellingLayer) {
    const Material m = ap();
    const TravellingLayer layer({.conductivity = m.thermal_conductivity,
                                 .capacity = m.density * m.specific_heat,
                                 .regression_rate = 0.0045,
                                 .flux = paper_flux + m.heat_of_reaction * m.density * 0.0045,
                                 .cold_temperature = 300.0});
    EXPECT_EQ(At("travelling-layer")("temperature"), layer.steady(y, 480e-6));
    EXPECT_EQ(At("travelling-layer", {{"state", "heating"}})("temperature"), layer.heating(y, t));
}

TEST(TruthFaces, ThermalLaminate) {
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

TEST(TruthFaces, ConductingInclusion) {
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

TEST(TruthFaces, Inclusions) {
    const CircularInclusion disc({.inclusion = ap(),
                                  .matrix = binder(),
                                  .radius = 30e-6,
                                  .far_xx = 1e6,
                                  .far_yy = -2e6,
                                  .far_xy = 1.5e6});
    const At at("circular-inclusion", {{"radius", 30e-6}});
    at.expect("displacement", disc.displacement(x, y));
    at.expect_stress(disc.stress(x, y));

    const FadedInclusion faded(disc, 50e-6, 115e-6);
    const At fading("faded-inclusion", {{"radius", 30e-6}, {"whole", 50e-6}});
    fading.expect("displacement", faded.displacement(x, y));
    fading.expect_stress(faded.stress(x, y));
    fading.expect("body_force", faded.body_force(x, y));
}

TEST(TruthFaces, Sandwiches) {
    const SandwichElements coarse{.degree = 3, .layers = 2, .ratio = 0.25};
    const Parameters given{{"degree", 3.0}, {"layers", 2.0}, {"ratio", 0.25}};
    const ElasticSandwich elastic(paper_sandwich(), 2e6, Support::roller, coarse);
    const At at("elastic-sandwich", given);
    at.expect("displacement", elastic.displacement(x, y));
    at.expect_stress(elastic.stress(x, y));

    const ThermalSandwich thermal(paper_sandwich(), paper_heating(), coarse);
    const At heat("thermal-sandwich", given);
    EXPECT_EQ(heat("temperature"), thermal.temperature(x, y));
    heat.expect("heat_flux", thermal.heat_flux(x, y));
}

TEST(TruthFaces, WilliamsCorner) {
    const At at("williams-corner");
    EXPECT_EQ(at("corner_exponent"), corner_exponent(ap(), binder()));
    EXPECT_EQ(at("dundurs_alpha"), dundurs(ap(), binder()).alpha);
    EXPECT_EQ(at("dundurs_beta"), dundurs(ap(), binder()).beta);
    EXPECT_EQ(at("even_stress"), even_stress(ap(), binder(), 2e6));
}

void expect_motion(const At& at, const Eigen::Vector2d& velocity, const Eigen::Vector2d& origin,
                   const Eigen::Matrix2d& gradient) {
    at.expect("velocity", velocity);
    at.expect("reference_map", origin);
    at.expect("displacement", Eigen::Vector2d(x, y) - origin);
    at.expect_matrix("deformation_gradient", gradient);
}

TEST(TruthFaces, RotationAndShear) {
    const Eigen::Vector2d here(x, y);
    const RigidRotation turning(90.0, {1e-6, -2e-6});
    Eigen::Matrix2d initial;
    initial << 1e6, 5e5, 5e5, -1e6;
    const At turned("rigid-rotation", {{"rate", 90.0}, {"centre_x", 1e-6}, {"centre_y", -2e-6}});
    expect_motion(turned, turning.velocity(here), turning.origin(here, t),
                  turning.deformation_gradient(t));
    turned.expect_symmetric("stress", turning.stress(initial, t));

    const SimpleShear sliding(90.0, -200e-6);
    const At slid("simple-shear", {{"rate", 90.0}, {"base", -200e-6}});
    expect_motion(slid, sliding.velocity(here), sliding.origin(here, t),
                  sliding.deformation_gradient(t));
    slid.expect_symmetric("strain", sliding.strain(t));
    slid.expect_symmetric("stress", sliding.stress(binder().shear_modulus, t));
}

TEST(TruthFaces, FlowAndWavyShear) {
    const Eigen::Vector2d here(x, y);
    const UniaxialFlow flow(0.02, -200e-6, 250e-6);
    const At flown("uniaxial-flow", {{"speed", 0.02}, {"base", -200e-6}, {"length", 250e-6}});
    expect_motion(flown, flow.velocity(here), flow.origin(here, t),
                  flow.deformation_gradient(here, t));
    flown.expect_symmetric("strain", flow.strain(here, t));

    const WavyShear wavy(0.02, 0.03, 200e-6);
    const At waved("wavy-shear", {{"drift", 0.02}, {"speed", 0.03}, {"width", 200e-6}});
    expect_motion(waved, wavy.velocity(here), wavy.origin(here, t),
                  wavy.deformation_gradient(here, t));
    waved.expect_symmetric("strain", wavy.strain(here, t));
}

TEST(TruthFaces, CarriedProfile) {
    const CarriedProfile profile({.amplitude = 2.0,
                                  .period = 240e-6,
                                  .phase = 0.3,
                                  .column = ColumnShape::bump,
                                  .middle = -100e-6,
                                  .width = 50e-6});
    const Eigen::Vector2d velocity(0.001, 0.004);
    const Eigen::Vector2d start = Eigen::Vector2d(x, y) - velocity * t;
    const At at("carried-profile", {{"amplitude", 2.0},
                                    {"phase", 0.3},
                                    {"column", "bump"},
                                    {"middle", -100e-6},
                                    {"height", 50e-6},
                                    {"velocity_x", 0.001},
                                    {"velocity_y", 0.004}});
    EXPECT_EQ(at("profile"), profile.value(start));
    at.expect("profile_gradient", profile.gradient(start));
    EXPECT_EQ(at("profile_rate"), profile.rate(start, velocity, Eigen::Vector2d::Zero()));
}

TEST(TruthFaces, Fronts) {
    const RegressingWave wave(15e-6, 240e-6, 0.0045);
    const At smooth("regressing-wave", {{"amplitude", 15e-6}});
    EXPECT_EQ(smooth("surface"), wave.height(x, t));
    EXPECT_EQ(smooth("surface_slope"), wave.slope(x, t));
    EXPECT_EQ(At("regressing-wave-envelope", {{"amplitude", 15e-6}})("surface"),
              wave.envelope(x, t));
    EXPECT_EQ(At("regressing-zigzag", {{"right", 0.8}})("surface"),
              RegressingZigzag(0.8, 0.5, 240e-6, 0.0045).height(x, t));
}

TEST(TruthFaces, FrontsOfTwoRates) {
    const JumpingFront jumping({.width = 240e-6,
                                .left = -10e-6,
                                .right = 35e-6,
                                .strip_rate = 0.002,
                                .outer_rate = 0.005});
    const At strip("jumping-front", {{"left", -10e-6}, {"right", 35e-6}});
    EXPECT_EQ(strip("surface"), jumping.height(x, t));
    EXPECT_EQ(strip("surface_slope"), jumping.slope(x, t));

    const RefractedFront refracted({.left = 0.0,
                                    .right = 35e-6,
                                    .lean = 0.3,
                                    .slab_rate = 0.002,
                                    .outer_rate = 0.005,
                                    .width = 240e-6});
    const At slab("refracted-front", {{"left", 0.0}, {"right", 35e-6}, {"lean", 0.3}});
    EXPECT_EQ(slab("surface"), refracted.height(x, t));
    EXPECT_EQ(slab("surface_slope"), refracted.slope(x, t));
}

TEST(TruthFaces, BurningSandwichFront) {
    const BurningSandwichFront front(paper_sandwich(), paper_flame(), {.degree = 3, .layers = 3});
    const At at("burning-sandwich-front", {{"degree", 3.0}, {"layers", 3.0}});
    EXPECT_EQ(at("temperature"), front.temperature(x, y));
    EXPECT_EQ(at("surface"), front.height(x));
    EXPECT_EQ(at("surface_slope"), front.slope(x));
    EXPECT_EQ(at("surface_temperature"), front.surface_temperature(x));
    EXPECT_EQ(at("regression_rate"), front.regression_rate());
    EXPECT_EQ(at("regression_rate_uncertainty"), front.regression_rate_uncertainty());
    EXPECT_EQ(at("mean_burn_rate"), front.mean_burn_rate());
    EXPECT_EQ(at("interface_temperature"), front.interface_temperature());
    EXPECT_EQ(at("notch_depth"), front.notch_depth());
}

TEST(TruthFaces, ManufacturedHeat) {
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

void expect_body(const std::string& waves, const ManufacturedElasticity& elastic,
                 const WavyBody& body) {
    const At at("manufactured-elastic-body",
                {{"waves", waves}, {"height", 10e-6}, {"load_vertical", 1e6}});
    EXPECT_EQ(at("surface"), body.surface(x));
    at.expect("displacement", elastic.displacement(x, y));
    at.expect_stress(elastic.stress(x, y));
    at.expect("body_force", elastic.body_force(x, y));
    at.expect("surface_traction", traction(elastic.stress(x, body.surface(x)), body.slope(x)));
}

TEST(TruthFaces, ManufacturedElasticBody) {
    const WavyBody body{.width = 240e-6, .depth = 240e-6, .height = 10e-6, .phase = 0.7};
    const ElasticModuli moduli{.bulk = ap().bulk_modulus, .shear = ap().shear_modulus};
    expect_body("clamped", {ClampedWaves{body, 4e-6}, moduli}, body);
    expect_body("rolling", {RollingWaves{body, moduli, 4e-6, 2e6}, moduli}, body);
    expect_body("pressed", {PressedWaves{body, moduli, 4e-6, {-2e6, 1e6}}, moduli}, body);
}

TEST(TruthFaces, ManufacturedElasticStrip) {
    const ManufacturedStrip strip(
        {.width = 240e-6,
         .strip = 50e-6,
         .depth = 120e-6,
         .outer = {.bulk = ap().bulk_modulus, .shear = ap().shear_modulus},
         .inner = {.bulk = binder().bulk_modulus, .shear = binder().shear_modulus},
         .stress = 1e6});
    const At at("manufactured-elastic-strip", {{"strip", 50e-6}});
    at.expect("displacement", strip.displacement(x, y));
    at.expect_stress(strip.stress(x, y));
    at.expect("body_force", strip.body_force(x, y));
    at.expect("surface_traction", traction(strip.stress(x, 0.0), 0.0));
}

}  // namespace

}  // namespace crawford::reference
