#include "reference/burning_sandwich_front.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "reference/front_space.hpp"
#include "reference/slab.hpp"
#include "reference/truth_registry.hpp"

namespace crawford::reference {
namespace {

constexpr double strip = 30e-6, half_width = 120e-6, depth = 480e-6;
constexpr SandwichElements coarse{.degree = 4, .layers = 5, .ratio = 0.3};

const BurningSandwichFront& paper() {
    static const BurningSandwichFront front(paper_sandwich(), paper_flame());
    return front;
}

double rate_of(const Material& material, double surface) {
    return material.pyrolysis_prefactor * std::exp(-material.activation_temperature / surface);
}

const Material& material_at(double x) {
    static const Material inner = binder(), outer = ap();
    return std::abs(x) < strip ? inner : outer;
}

TEST(BurningSandwichFront, SpeedStandsAsTheMeshIsRefined) {
    const double fine = paper().regression_rate();
    double previous = 1.0;
    for (const SandwichElements& elements : {SandwichElements{.degree = 3, .layers = 3}, coarse,
                                             SandwichElements{.degree = 5, .layers = 7}}) {
        const BurningSandwichFront front(paper_sandwich(), paper_flame(), elements);
        const double error = std::abs(front.regression_rate() / fine - 1.0);
        EXPECT_LT(error, previous / 2.5);
        // The stated uncertainty covers what a finer mesh finds.
        EXPECT_GT(front.regression_rate_uncertainty(), error * fine);
        previous = error;
    }
    EXPECT_LT(previous, 5e-5);
    EXPECT_LT(paper().regression_rate_uncertainty(), 5e-5 * fine);
    EXPECT_GT(paper().regression_rate_uncertainty(), 0.0);
}

TEST(BurningSandwichFront, IsThePapers) {
    // Degree 8 with 12 layers, and degree 10 with 8 layers of ratio 0.15, agree to a millionth.
    EXPECT_NEAR(paper().regression_rate(), 0.00499460, 3e-8);
    EXPECT_NEAR(paper().mean_burn_rate(), 0.00486045, 1e-8);
    EXPECT_NEAR(paper().interface_temperature(), 874.493, 2e-3);
    EXPECT_NEAR(paper().notch_depth(), 11.439e-6, 3e-9);
}

TEST(BurningSandwichFront, HeatInIsEnthalpyOut) {
    EXPECT_NEAR(paper().heat_in() / paper().enthalpy_out(), 1.0, 3e-6);
}

TEST(BurningSandwichFront, EveryPlaceKeepsPace) {
    for (const double x :
         {0.0, 7e-6, 20e-6, 28e-6, 29.7e-6, 30.5e-6, 33e-6, 50e-6, 90e-6, 120e-6}) {
        const double pace = rate_of(material_at(x), paper().surface_temperature(x)) *
                            std::hypot(1.0, paper().slope(x));
        EXPECT_NEAR(pace / paper().regression_rate(), 1.0, 1e-4) << x;
    }
}

TEST(BurningSandwichFront, OuterMaterialLeadsAtTheInterface) {
    const double v = paper().regression_rate();
    EXPECT_NEAR(rate_of(ap(), paper().interface_temperature()) / v, 1.0, 1e-6);
    EXPECT_NEAR(paper().slope(std::nextafter(strip, 1.0)), 0.0, 1e-3);
    const double strip_rate = rate_of(binder(), paper().interface_temperature());
    EXPECT_NEAR(paper().slope(strip), -std::sqrt(std::pow(v / strip_rate, 2) - 1.0), 1e-5);
    for (const double x : {1e-6, 10e-6, 25e-6, 29.9e-6}) EXPECT_LT(paper().slope(x), 0.0) << x;
    for (const double x : {30.1e-6, 35e-6, 60e-6, 110e-6}) EXPECT_GT(paper().slope(x), 0.0) << x;
    // A consequence: level at the side by symmetry, it is as hot there.
    EXPECT_NEAR(paper().surface_temperature(half_width), paper().interface_temperature(), 1e-3);
}

TEST(BurningSandwichFront, HeightIsTheIntegralOfSlopeAndSymmetric) {
    EXPECT_EQ(paper().height(half_width), 0.0);
    EXPECT_DOUBLE_EQ(paper().height(-40e-6), paper().height(40e-6));
    EXPECT_DOUBLE_EQ(paper().slope(-40e-6), -paper().slope(40e-6));
    EXPECT_DOUBLE_EQ(paper().temperature(-20e-6, -50e-6), paper().temperature(20e-6, -50e-6));
    for (const double x : {5e-6, 25e-6, 31e-6, 70e-6}) {
        constexpr double h = 1e-8;
        const double slope = (paper().height(x + h) - paper().height(x - h)) / (2.0 * h);
        EXPECT_NEAR(slope, paper().slope(x), 1e-5);
    }
}

/// Second-order differences of the temperature in x and y themselves, by no formula of the mesh.
struct Differences {
    double gradient_x, gradient_y, laplacian;
};
Differences differences(double x, double y) {
    constexpr double h = 0.1e-6;
    const auto at = [](double a, double b) { return paper().temperature(a, b); };
    return {(at(x + h, y) - at(x - h, y)) / (2 * h), (at(x, y + h) - at(x, y - h)) / (2 * h),
            (at(x + h, y) + at(x - h, y) + at(x, y + h) + at(x, y - h) - 4 * at(x, y)) / (h * h)};
}

TEST(BurningSandwichFront, ObeysTheHeatEquationInSpace) {
    for (const double x : {13e-6, 24e-6, 37e-6, 44e-6, 75e-6})
        for (const double below : {5e-6, 16e-6, 42e-6}) {
            const Material& material = material_at(x);
            const Differences t = differences(x, paper().height(x) - below);
            const double carried = material.density * material.specific_heat *
                                   paper().regression_rate() * t.gradient_y;
            EXPECT_NEAR(material.thermal_conductivity * t.laplacian / carried, 1.0, 2e-2)
                << x << " " << below;
        }
}

TEST(BurningSandwichFront, TakesTheFluxThroughItsSlopedSurface) {
    for (const double x : {15e-6, 22e-6, 27e-6, 40e-6, 60e-6}) {
        const Material& material = material_at(x);
        // Extrapolated to the surface from two depths.
        const auto flux_at = [&](double below) {
            const Differences t = differences(x, paper().height(x) - below);
            const double p = paper().slope(x);
            return material.thermal_conductivity * (t.gradient_y - p * t.gradient_x) /
                   std::hypot(1.0, p);
        };
        const double flux = 3.0 * flux_at(0.5e-6) - 3.0 * flux_at(1e-6) + flux_at(1.5e-6);
        const double rate = rate_of(material, paper().surface_temperature(x));
        const double wanted = (x < strip ? 160.0 : 200.0) * calorie_per_second_per_cm2 +
                              material.heat_of_reaction * material.density * rate;
        EXPECT_NEAR(flux / wanted, 1.0, 3e-3) << x;
    }
}

TEST(BurningSandwichFront, OneMaterialIsTheSlab) {
    SandwichGeometry geometry = paper_sandwich();
    geometry.inner = ap();
    SandwichFlame flame = paper_flame();
    flame.inner_flux = flame.outer_flux;
    const BurningSandwichFront front(geometry, flame, coarse);
    const Slab slab({.material = ap(),
                     .model = SlabModel::thermal,
                     .regression = Regression::pyrolysis,
                     .heat_flux = flame.outer_flux,
                     .pressure = 0.0,
                     .cold_temperature = 300.0,
                     .depth = depth});
    EXPECT_NEAR(front.regression_rate() / slab.burn_rate(), 1.0, 1e-7);
    EXPECT_NEAR(front.mean_burn_rate() / slab.burn_rate(), 1.0, 1e-7);
    EXPECT_NEAR(front.notch_depth(), 0.0, 1e-12);
    for (const double y : {0.0, -10e-6, -60e-6, -300e-6})
        EXPECT_NEAR(front.temperature(45e-6, y), slab.temperature(y), 0.02) << y;
}

TEST(BurningSandwichFront, HoldsForOtherSandwiches) {
    for (const double part : {0.5, 1.0, 2.0, 3.0}) {
        SandwichGeometry geometry = paper_sandwich();
        geometry.strip *= part;
        const BurningSandwichFront front(geometry, paper_flame(), coarse);
        EXPECT_LT(front.regression_rate_uncertainty(), 2e-3 * front.regression_rate()) << part;
    }
}

/// What is said of an input that is refused.
std::string refusal(const SandwichGeometry& geometry, const SandwichFlame& flame,
                    const SandwichElements& elements = coarse) {
    try {
        const BurningSandwichFront front(geometry, flame, elements);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(BurningSandwichFront, RefusesAStripThatIsFaster) {
    SandwichGeometry flipped = paper_sandwich();
    std::swap(flipped.inner, flipped.outer);
    EXPECT_THAT(refusal(flipped, paper_flame()),
                testing::HasSubstr("the outer material must burn at least as fast as the strip"));
    EXPECT_THROW(
        truth("burning-sandwich-front", {{"inner_material", "AP"}, {"outer_material", "binder"}}),
        InputError);
}

TEST(BurningSandwichFront, RefusesAFlameTooWeakToBurnAnything) {
    SandwichFlame flame = paper_flame();
    flame.outer_flux = 1e-12;
    EXPECT_THAT(refusal(paper_sandwich(), flame), testing::HasSubstr("outer_flux"));
}

TEST(BurningSandwichFront, FailsByNameWhereTheStripLeads) {
    SandwichFlame flame = paper_flame();
    flame.inner_flux *= 3.0;
    EXPECT_THROW(BurningSandwichFront(paper_sandwich(), flame, coarse), NumericalFailure);
}

TEST(BurningSandwichFront, RefusesWhatIsMissingOrOutOfRange) {
    const auto with = [](double SandwichGeometry::*member, double value) {
        SandwichGeometry geometry = paper_sandwich();
        geometry.*member = value;
        return geometry;
    };
    EXPECT_THAT(refusal(with(&SandwichGeometry::strip, missing), paper_flame()),
                "strip is missing");
    EXPECT_NE(refusal(with(&SandwichGeometry::strip, half_width), paper_flame()), "");
    // Their meshes would not fit into memory.
    EXPECT_THAT(refusal(with(&SandwichGeometry::strip, 0.02 * half_width), paper_flame()),
                testing::HasSubstr("at least 1/40 of half_width"));
    EXPECT_NE(refusal(with(&SandwichGeometry::strip, 0.98 * half_width), paper_flame()), "");
    EXPECT_NE(refusal(with(&SandwichGeometry::depth, 2e6 * half_width), paper_flame()), "");
    EXPECT_NE(refusal(with(&SandwichGeometry::depth, -1.0), paper_flame()), "");
    EXPECT_THAT(refusal(paper_sandwich(), {}), "inner_flux is missing");
    SandwichGeometry cold = paper_sandwich();
    cold.outer.pyrolysis_prefactor = 0.0;
    EXPECT_NE(refusal(cold, paper_flame()), "");
    EXPECT_NE(refusal(paper_sandwich(), paper_flame(), {.degree = 2, .layers = 3}), "");
    EXPECT_NE(refusal(paper_sandwich(), paper_flame(), {.degree = 4, .layers = 1}), "");
    EXPECT_NE(refusal(paper_sandwich(), paper_flame(), {.degree = 4, .layers = 3, .ratio = 1.0}),
              "");
    EXPECT_THROW(paper().height(1e-3), std::invalid_argument);
    EXPECT_THROW(paper().temperature(0.0, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
