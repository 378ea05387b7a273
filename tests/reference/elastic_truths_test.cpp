#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "reference/circular_inclusion.hpp"
#include "reference/elastic_laminate.hpp"
#include "reference/faded_inclusion.hpp"

namespace crawford::reference {
namespace {

constexpr double um = 1e-6;
constexpr double far = 2e6;  // [Pa]

using Field = std::function<Eigen::Vector2d(double, double)>;

/// Row k: gradient of component k, by central differences with one Richardson step: error h^4.
Eigen::Matrix2d gradient(const Field& field, double x, double y, double h) {
    const auto central = [&](double d) {
        Eigen::Matrix2d g;
        g.col(0) = (field(x + d, y) - field(x - d, y)) / (2.0 * d);
        g.col(1) = (field(x, y + d) - field(x, y - d)) / (2.0 * d);
        return g;
    };
    return (4.0 * central(0.5 * h) - central(h)) / 3.0;
}

/// Hooke's law in plane strain, written with K and mu; the truths use lambda and kappa.
PlaneStrainStress hooke(const Material& material, const Eigen::Matrix2d& g) {
    const double third = g.trace() / 3.0;
    const double mean = material.bulk_modulus * g.trace();
    const double twice = 2.0 * material.shear_modulus;
    return {.xx = mean + twice * (g(0, 0) - third),
            .yy = mean + twice * (g(1, 1) - third),
            .zz = mean - twice * third,
            .xy = 0.5 * twice * (g(0, 1) + g(1, 0))};
}

void expect_equal(const PlaneStrainStress& a, const PlaneStrainStress& b, double tolerance) {
    EXPECT_NEAR(a.xx, b.xx, tolerance);
    EXPECT_NEAR(a.yy, b.yy, tolerance);
    EXPECT_NEAR(a.zz, b.zz, tolerance);
    EXPECT_NEAR(a.xy, b.xy, tolerance);
}

/// div sigma, by differences of a stress.
template <class Truth>
Eigen::Vector2d divergence(const Truth& truth, double x, double y, double h) {
    const Field first = [&](double a, double b) {
        const auto s = truth.stress(a, b);
        return Eigen::Vector2d(s.xx, s.xy);
    };
    const Field second = [&](double a, double b) {
        const auto s = truth.stress(a, b);
        return Eigen::Vector2d(s.xy, s.yy);
    };
    return {gradient(first, x, y, h).trace(), gradient(second, x, y, h).trace()};
}

LaminateConditions laminate() {
    return {.inner = binder(),
            .outer = ap(),
            .period = 240 * um,
            .strip = 60 * um,
            .axial_strain = -1e-3,
            .shear = 2e-3};
}

TEST(ElasticLaminate, StressIsHookeOfTheDisplacement) {
    const ElasticLaminate exact(laminate());
    const Field u = [&](double x, double y) { return exact.displacement(x, y); };
    for (const double x : {0.0, 25 * um, 40 * um, 119 * um, 121 * um, -70 * um, 230 * um}) {
        const Material material = std::abs(std::remainder(x, 240 * um)) < 30 * um ? binder() : ap();
        expect_equal(exact.stress(x), hooke(material, gradient(u, x, -50 * um, 0.5 * um)),
                     1e-8 * std::abs(exact.stress(x).yy));  // round-off of the differences
    }
}

TEST(ElasticLaminate, IsPeriodicAndCarriesOneTraction) {
    const ElasticLaminate exact(laminate());
    const Eigen::Vector2d shift =
        exact.displacement(170 * um, -9 * um) - exact.displacement(-70 * um, -9 * um);
    EXPECT_LT(shift.norm(), 1e-20);
    // No jump of the displacement; xx and xy are one number, yy is not.
    const Eigen::Vector2d jump =
        exact.displacement(30 * um + 1e-15, 0) - exact.displacement(30 * um - 1e-15, 0);
    EXPECT_LT(jump.norm(), 1e-16);
    EXPECT_EQ(exact.stress(0.0).xx, exact.stress(100 * um).xx);
    EXPECT_EQ(exact.stress(0.0).xy, exact.stress(100 * um).xy);
    EXPECT_GT(std::abs(exact.stress(0.0).yy - exact.stress(100 * um).yy), 1e5);
}

TEST(ElasticLaminate, OfOneMaterialIsUniaxialStrainAndSimpleShear) {
    LaminateConditions one = laminate();
    one.inner = one.outer;
    const ElasticLaminate exact(one);
    EXPECT_NEAR(exact.displacement(55 * um, 0.0).norm(), 0.0, 1e-20);
    EXPECT_NEAR(exact.stress(0.0).yy, -1e-3 * ap().uniaxial_modulus(), 1.0);
    EXPECT_NEAR(exact.stress_xy(), 2e-3 * ap().shear_modulus, 1.0);
}

TEST(ElasticLaminate, ABalancedStripLeavesItsEndEvenlyPressed) {
    for (const double a : {0.0, 0.3, 0.9}) {
        LaminateConditions pair{
            .inner = {}, .outer = ap(), .period = 2.0, .strip = 1.0, .axial_strain = 1e-3};
        pair.inner = balanced_strip(pair.outer, pair.strip, pair.period, a);
        const ElasticLaminate exact(pair);
        EXPECT_NEAR(exact.stress(0.0).yy / exact.stress(0.9).yy, 1.0, 1e-13) << a;
        EXPECT_NEAR(exact.displacement(1.0, 0.0).x(), 0.0, 1e-18) << a;
        EXPECT_NEAR(exact.displacement(0.5, 0.0).x(), -0.5 * a * 1e-3, 1e-16) << a;
    }
}

TEST(ElasticLaminate, StiffnessIsThatOfItsLayers) {
    const ElasticLaminate exact(laminate());
    const double mean = 0.25 * exact.stress(0.0).yy + 0.75 * exact.stress(100 * um).yy;
    const double stiffness = axial_stiffness({{binder(), 0.25}, {ap(), 0.75}});
    EXPECT_NEAR(mean / -1e-3 / stiffness, 1.0, 1e-13);
    // One layer in three parts is one layer.
    const double split = axial_stiffness({{binder(), 0.25}, {ap(), 0.5}, {ap(), 0.25}});
    EXPECT_NEAR(split / stiffness, 1.0, 1e-13);
    EXPECT_THROW(axial_stiffness({{ap(), 0.5}, {binder(), 0.4}}), std::invalid_argument);
    EXPECT_THROW(axial_stiffness({}), std::invalid_argument);
}

TEST(ElasticLaminate, RefusesByName) {
    LaminateConditions bad = laminate();
    bad.strip = bad.period;
    EXPECT_THROW(ElasticLaminate{bad}, std::invalid_argument);
    bad = laminate();
    bad.inner.shear_modulus = missing;
    EXPECT_THROW(ElasticLaminate{bad}, std::invalid_argument);
    EXPECT_THROW(balanced_strip(ap(), 1.0, 4.0, 0.34), std::invalid_argument);
}

InclusionConditions disc(const Material& inclusion, const Material& matrix) {
    return {.inclusion = inclusion,
            .matrix = matrix,
            .radius = 40 * um,
            .far_xx = 0.5 * far,
            .far_yy = -far,
            .far_xy = 0.7 * far};
}

class EachInclusion : public ::testing::TestWithParam<InclusionConditions> {};

// Nothing below uses how the coefficients were found: what the solution promises is asked of it.
TEST_P(EachInclusion, IsBonded) {
    const CircularInclusion exact(GetParam());
    const double radius = GetParam().radius;
    for (int k = 0; k < 13; ++k) {
        const double angle = 0.1 + 0.5 * k;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double in = radius * (1.0 - 1e-13);
        const double out = radius * (1.0 + 1e-13);
        EXPECT_LT(
            (exact.displacement(in * c, in * s) - exact.displacement(out * c, out * s)).norm(),
            1e-12 * radius * exact.gradient(out * c, out * s).norm());
        const auto inside = exact.stress(in * c, in * s);
        const auto outside = exact.stress(out * c, out * s);
        EXPECT_NEAR(inside.xx * c + inside.xy * s, outside.xx * c + outside.xy * s, 1e-11 * far);
        EXPECT_NEAR(inside.xy * c + inside.yy * s, outside.xy * c + outside.yy * s, 1e-11 * far);
    }
}

TEST_P(EachInclusion, ObeysHookeAndEquilibrium) {
    const CircularInclusion exact(GetParam());
    const Field u = [&](double x, double y) { return exact.displacement(x, y); };
    for (const auto& [x, y] :
         {std::pair{10 * um, -15 * um}, {35 * um, 30 * um}, {-90 * um, 5 * um}}) {
        const bool inside = std::hypot(x, y) < GetParam().radius;
        const Material& material = inside ? GetParam().inclusion : GetParam().matrix;
        const Eigen::Matrix2d g = exact.gradient(x, y);
        EXPECT_LT((gradient(u, x, y, 0.2 * um) - g).norm(), 1e-8 * g.norm());
        // K/mu = 4268 multiplies the round-off of the trace
        expect_equal(exact.stress(x, y), hooke(material, g), 1e-10 * far);
        EXPECT_LT(divergence(exact, x, y, 0.2 * um).norm(), 1e-7 * far / GetParam().radius);
    }
}

TEST_P(EachInclusion, TendsToTheFarStress) {
    const CircularInclusion exact(GetParam());
    const double r = 1e4 * GetParam().radius;  // what the disc adds falls as (R/r)^2
    const auto s = exact.stress(0.6 * r, 0.8 * r);
    EXPECT_NEAR(s.xx, GetParam().far_xx, 1e-7 * far);
    EXPECT_NEAR(s.yy, GetParam().far_yy, 1e-7 * far);
    EXPECT_NEAR(s.xy, GetParam().far_xy, 1e-7 * far);
}

INSTANTIATE_TEST_SUITE_P(CircularInclusion, EachInclusion,
                         ::testing::Values(disc(ap(), binder()), disc(binder(), ap()),
                                           disc(ap(), ap())));

TEST(CircularInclusion, OfTheSameMaterialIsNotThere) {
    const CircularInclusion exact(disc(ap(), ap()));
    for (const double x : {0.0, 20 * um, 41 * um, 200 * um}) {
        EXPECT_NEAR(exact.stress(x, 3 * um).xx, 0.5 * far, 1e-9 * far);
        EXPECT_NEAR(exact.stress(x, 3 * um).xy, 0.7 * far, 1e-9 * far);
    }
}

// Kirsch (1898): a hole triples the stress at its sides and reverses it at its ends.
TEST(CircularInclusion, TendsToKirschsHole) {
    Material nothing = ap();
    nothing.bulk_modulus *= 1e-9;
    nothing.shear_modulus *= 1e-9;
    const CircularInclusion hole(
        {.inclusion = nothing, .matrix = ap(), .radius = 1.0, .far_xx = far});
    EXPECT_NEAR(hole.stress(0.0, 1.0 + 1e-12).xx, 3.0 * far, 1e-7 * far);
    EXPECT_NEAR(hole.stress(1.0 + 1e-12, 0.0).yy, -far, 1e-7 * far);
    EXPECT_NEAR(hole.stress(0.0, 0.0).xx, 0.0, 1e-7 * far);
}

TEST(CircularInclusion, RefusesByName) {
    InclusionConditions bad = disc(ap(), binder());
    bad.radius = missing;
    EXPECT_THROW(CircularInclusion{bad}, std::invalid_argument);
    bad = disc(ap(), binder());
    bad.far_xy = missing;
    EXPECT_THROW(CircularInclusion{bad}, std::invalid_argument);
    bad = disc(ap(), binder());
    bad.matrix.bulk_modulus = -1.0;
    EXPECT_THROW(CircularInclusion{bad}, std::invalid_argument);
}

FadedInclusion faded(const Material& inclusion, const Material& matrix) {
    return {CircularInclusion(disc(inclusion, matrix)), 50 * um, 110 * um};
}

TEST(FadedInclusion, IsTheInclusionNearItAndNothingFarAway) {
    const FadedInclusion exact = faded(ap(), binder());
    const CircularInclusion whole(disc(ap(), binder()));
    EXPECT_EQ(exact.displacement(30 * um, 39 * um), whole.displacement(30 * um, 39 * um));
    EXPECT_EQ(exact.body_force(30 * um, 39 * um).norm(), 0.0);
    EXPECT_EQ(exact.displacement(80 * um, 80 * um).norm(), 0.0);
    EXPECT_EQ(exact.stress(80 * um, 80 * um).yy, 0.0);
    EXPECT_EQ(exact.body_force(80 * um, 80 * um).norm(), 0.0);
}

// The closed form of b against differences of a stress that is itself held against differences of
// the displacement.
TEST(FadedInclusion, BodyForceHoldsItsStress) {
    for (const auto& [inclusion, matrix] : {std::pair{ap(), binder()}, {binder(), ap()}}) {
        const FadedInclusion exact = faded(inclusion, matrix);
        const Field w = [&](double x, double y) { return exact.displacement(x, y); };
        for (const auto& [x, y] :
             {std::pair{45 * um, 40 * um}, {-20 * um, 75 * um}, {60 * um, -80 * um}}) {
            const auto s = exact.stress(x, y);
            const double size = std::abs(s.xx) + std::abs(s.yy) + std::abs(s.xy);
            expect_equal(s, hooke(matrix, gradient(w, x, y, 0.5 * um)), 1e-6 * size);
            const Eigen::Vector2d b = exact.body_force(x, y);
            EXPECT_LT((divergence(exact, x, y, 0.5 * um) + b).norm(), 1e-6 * b.norm());
        }
    }
}

TEST(FadedInclusion, RefusesRadiiOutOfOrder) {
    const CircularInclusion inclusion(disc(ap(), binder()));
    EXPECT_THROW(FadedInclusion(inclusion, 40 * um, 100 * um), std::invalid_argument);
    EXPECT_THROW(FadedInclusion(inclusion, 50 * um, 50 * um), std::invalid_argument);
    EXPECT_THROW(FadedInclusion(inclusion, missing, 50 * um), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
