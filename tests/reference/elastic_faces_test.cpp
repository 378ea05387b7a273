/// The common face of a truth of stress or motion tells what its class tells, bit for bit and under the right name.
#include <gtest/gtest.h>

#include <string>

#include "reference/elastic_sandwich.hpp"
#include "reference/exact_motions.hpp"
#include "reference/faded_inclusion.hpp"
#include "reference/manufactured_elastic_body.hpp"
#include "reference/manufactured_elastic_strip.hpp"
#include "reference/thermal_sandwich.hpp"
#include "reference/williams_corner.hpp"
#include "tests/reference/truth_at.hpp"

namespace crawford::reference {

namespace {

TEST(ElasticFaces, Inclusions) {
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

TEST(ElasticFaces, Sandwiches) {
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

TEST(ElasticFaces, WilliamsCorner) {
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

TEST(ElasticFaces, RotationAndShear) {
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

TEST(ElasticFaces, FlowAndWavyShear) {
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

TEST(ElasticFaces, ManufacturedElasticBody) {
    const WavyBody body{.width = 240e-6, .depth = 240e-6, .height = 10e-6, .phase = 0.7};
    const ElasticModuli moduli{.bulk = ap().bulk_modulus, .shear = ap().shear_modulus};
    expect_body("clamped", {ClampedWaves{body, 4e-6}, moduli}, body);
    expect_body("rolling", {RollingWaves{body, moduli, 4e-6, 2e6}, moduli}, body);
    expect_body("pressed", {PressedWaves{body, moduli, 4e-6, {-2e6, 1e6}}, moduli}, body);
}

TEST(ElasticFaces, ManufacturedElasticStrip) {
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
