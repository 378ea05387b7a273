#include <gtest/gtest.h>

#include <complex>

#include "reference/manufactured_elastic_body.hpp"
#include "reference/manufactured_elastic_strip.hpp"

namespace crawford::reference {
namespace {

using Complex = std::complex<double>;
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr WavyBody body{.width = 1.0, .depth = 0.8, .height = 0.05, .phase = 0.7};
constexpr ElasticModuli moduli{.bulk = 5.0, .shear = 2.0};

/// Gradient of a displacement by complex steps: exact to round-off, and no differences.
template <class Displacement>
Matrix2d gradient(const Displacement& displacement, double x, double y) {
    constexpr double step = 1e-30;
    const auto along_x = displacement(Complex(x, step), Complex(y));
    const auto along_y = displacement(Complex(x), Complex(y, step));
    Matrix2d result;
    for (int k = 0; k < 2; ++k)
        result.row(k) << along_x[size_t(k)].imag() / step, along_y[size_t(k)].imag() / step;
    return result;
}

/// sigma = C:D in three dimensions, from K and mu.
PlaneStrainStress hooke(const Matrix2d& gradient) {
    const double p = -moduli.bulk * gradient.trace();
    const double third = gradient.trace() / 3.0;
    const double mu = moduli.shear;
    return {.xx = -p + 2.0 * mu * (gradient(0, 0) - third),
            .yy = -p + 2.0 * mu * (gradient(1, 1) - third),
            .zz = -p - 2.0 * mu * third,
            .xy = mu * (gradient(0, 1) + gradient(1, 0))};
}

/// Central difference, extrapolated once: error O(step^4).
template <class Function>
double slope_of(const Function& f, double at, double step) {
    const auto central = [&](double h) { return (f(at + h) - f(at - h)) / (2.0 * h); };
    return (4.0 * central(step / 2.0) - central(step)) / 3.0;
}

/// -div sigma from differences of the stress.
template <class Truth>
Vector2d minus_divergence(const Truth& truth, double x, double y, double step) {
    const auto along_x = [&](auto component) {
        return slope_of([&](double s) { return truth.stress(s, y).*component; }, x, step);
    };
    const auto along_y = [&](auto component) {
        return slope_of([&](double s) { return truth.stress(x, s).*component; }, y, step);
    };
    using S = PlaneStrainStress;
    return {-along_x(&S::xx) - along_y(&S::xy), -along_x(&S::xy) - along_y(&S::yy)};
}

template <class Displacement>
void expect_loads_balance(const Displacement& displacement) {
    const ManufacturedElasticity truth(displacement, moduli);
    for (const double x : {-0.43, 0.02, 0.31})
        for (const double y : {-0.75, -0.4, -0.06}) {
            const auto expected = hooke(gradient(displacement, x, y));
            const auto sigma = truth.stress(x, y);
            EXPECT_NEAR(sigma.xx, expected.xx, 1e-13);
            EXPECT_NEAR(sigma.yy, expected.yy, 1e-13);
            EXPECT_NEAR(sigma.zz, expected.zz, 1e-13);
            EXPECT_NEAR(sigma.xy, expected.xy, 1e-13);
            const auto value = displacement(x, y);
            EXPECT_NEAR(truth.displacement(x, y).x(), value[0], 1e-15);
            EXPECT_NEAR(truth.displacement(x, y).y(), value[1], 1e-15);
            // Forces are of size 10 here; what is left of the differences is 1e-8.
            EXPECT_LT((truth.body_force(x, y) - minus_divergence(truth, x, y, 1e-3)).norm(), 1e-7)
                << x << ' ' << y;
        }
}

// f = x^3 y^2 t: derivatives by hand.
TEST(Derivatives, AreThoseOfAPolynomial) {
    const auto field = [](const auto& x, const auto& y, const auto& t) {
        return std::array{x * x * x * y * y * t};
    };
    const double x = 1.5, y = -0.7, t = 2.0;
    const auto [f] = derivatives(field, x, y, t);
    EXPECT_NEAR(f.value, x * x * x * y * y * t, 1e-14);
    EXPECT_NEAR(f.x, 3.0 * x * x * y * y * t, 1e-14);
    EXPECT_NEAR(f.y, 2.0 * x * x * x * y * t, 1e-14);
    EXPECT_NEAR(f.t, x * x * x * y * y, 1e-14);
    EXPECT_NEAR(f.xx, 6.0 * x * y * y * t, 1e-14);
    EXPECT_NEAR(f.xy, 6.0 * x * x * y * t, 1e-14);
    EXPECT_NEAR(f.yy, 2.0 * x * x * x * t, 1e-14);
}

TEST(Derivatives, DoNotNeedATime) {
    const auto still = [](const auto& x, const auto& y) { return std::array{sin(x) * exp(y)}; };
    const auto timed = [&](const auto& x, const auto& y, const auto&) { return still(x, y); };
    const auto [f] = derivatives(still, 0.3, 0.4);
    const auto [g] = derivatives(timed, 0.3, 0.4, 5.0);
    for (const auto member :
         {&Derivatives::value, &Derivatives::x, &Derivatives::y, &Derivatives::t, &Derivatives::xx,
          &Derivatives::xy, &Derivatives::yy})
        EXPECT_NEAR(f.*member, g.*member, 1e-15);
}

TEST(ManufacturedElasticity, StressAndBodyForceFollowFromTheDisplacement) {
    expect_loads_balance(ClampedWaves{body, 0.1});
    expect_loads_balance(RollingWaves{body, moduli, 0.1, 0.3});
    expect_loads_balance(PressedWaves{body, moduli, 0.1, {-0.5, -0.2}});
}

// A traction is sigma.n: against Cauchy's formula in matrices.
TEST(ManufacturedElasticity, TractionIsThatOfTheOutwardNormal) {
    const PlaneStrainStress sigma{.xx = 1.0, .yy = -2.0, .zz = 5.0, .xy = 0.7};
    const Matrix2d matrix = (Matrix2d() << 1.0, 0.7, 0.7, -2.0).finished();
    for (const double angle : {-0.6, 0.0, 0.4}) {
        const Vector2d n(-std::sin(angle), std::cos(angle));
        EXPECT_LT((traction(sigma, std::tan(angle)) - matrix * n).norm(), 1e-15);
    }
}

TEST(ManufacturedElasticity, IsPeriodicAndHeldAtTheBottom) {
    const ManufacturedElasticity clamped(ClampedWaves{body, 0.1}, moduli);
    const ManufacturedElasticity rolling(RollingWaves{body, moduli, 0.1, 0.3}, moduli);
    const ManufacturedElasticity pressed(PressedWaves{body, moduli, 0.1, {-0.5, 0.0}}, moduli);
    for (const double x : {-0.4, 0.0, 0.15}) {
        const double bottom = body.surface(x) - body.depth;
        EXPECT_NEAR(clamped.displacement(x, bottom).norm(), 0.0, 1e-16);
        EXPECT_NEAR(pressed.displacement(x, bottom).norm(), 0.0, 1e-16);
        EXPECT_NEAR(rolling.displacement(x, bottom).y(), 0.0, 1e-16);
        const auto sigma = rolling.stress(x, bottom);
        const double slope = body.slope(x);
        EXPECT_NEAR(sigma.xx * slope - sigma.xy, -0.3 * slope, 1e-13);
        for (const auto* truth : {&clamped, &rolling, &pressed})
            EXPECT_LT((truth->displacement(x, -0.3) - truth->displacement(x + 1.0, -0.3)).norm(),
                      1e-15);
    }
    EXPECT_NEAR(rolling.displacement(0.0, body.surface(0.0) - body.depth).x(), 0.0, 1e-16);
    EXPECT_GT(std::abs(rolling.displacement(0.2, body.surface(0.2) - body.depth).x()), 0.01);
}

TEST(ManufacturedElasticity, ASurfaceCarriesTheLoadItIsMadeFor) {
    for (const SurfaceLoad load : {SurfaceLoad{-0.5, 0.0}, SurfaceLoad{0.0, -0.5}}) {
        const ManufacturedElasticity truth(PressedWaves{body, moduli, 0.1, load}, moduli);
        for (const double x : {-0.35, 0.0, 0.2, 0.4}) {
            const double slope = body.slope(x);
            const Vector2d found =
                std::hypot(1.0, slope) * traction(truth.stress(x, body.surface(x)), slope);
            EXPECT_NEAR(found.x(), -slope * load.normal, 1e-13);
            EXPECT_NEAR(found.y(), load.normal + load.vertical, 1e-13);
        }
    }
}

TEST(ManufacturedElasticity, SlopeIsThatOfTheSurface) {
    const auto surface = [](double x) { return body.surface(x); };
    EXPECT_NEAR(body.slope(0.2), slope_of(surface, 0.2, 1e-3), 1e-10);
}

TEST(ManufacturedElasticity, RefusesBadInput) {
    EXPECT_THROW(ManufacturedElasticity(ClampedWaves{body, 0.1}, {.bulk = 1.0}),
                 std::invalid_argument);
    EXPECT_THROW(ManufacturedElasticity(ClampedWaves{body, 0.1}, {.bulk = -1.0, .shear = 1.0}),
                 std::invalid_argument);
    WavyBody flat = body;
    flat.depth = 0.0;
    EXPECT_THROW(flat.require(), std::invalid_argument);
    EXPECT_THROW(WavyBody{.width = 1.0}.require(), std::invalid_argument);
}

constexpr double face = 0.125;

ElasticStrip strip(double ratio, double incompressibility) {
    const double mu = 2.5e6;
    return {.width = 1.0,
            .strip = 2.0 * face,
            .depth = 0.5,
            .outer = {.bulk = 1.2 * ratio * mu, .shear = ratio * mu},
            .inner = {.bulk = incompressibility * mu, .shear = mu},
            .stress = 1e6};
}

TEST(ManufacturedStrip, JoinsTwoMaterialsOfAnyContrast) {
    for (const double ratio : {1.0, 1e4, 1e8})
        for (const double incompressibility : {1.0, 1e5}) {
            const ManufacturedStrip truth(strip(ratio, incompressibility));
            for (const double y : {-0.4, -0.2, 0.0}) {
                const Vector2d in = truth.inner().displacement(face, y);
                const Vector2d out = truth.outer().displacement(face, y);
                // Round-off of what the strip moves by inside, up to 0.1 m.
                EXPECT_LT((in - out).norm(), 1e-16);
                const auto a = truth.inner().stress(face, y);
                const auto b = truth.outer().stress(face, y);
                // K/mu multiplies the round-off of div u: 1e-16 x 1e5 of 1 MPa.
                EXPECT_NEAR(a.xx, b.xx, 1e-3);
                EXPECT_NEAR(a.xy, b.xy, 1e-3);
                EXPECT_GT(std::abs(a.xx) + std::abs(a.xy), 1e4);
            }
        }
}

TEST(ManufacturedStrip, StressHasOneSizeWhateverTheModuli) {
    for (const double ratio : {1.0, 1e4, 1e8})
        for (const double incompressibility : {1.0, 1e5}) {
            const ManufacturedStrip truth(strip(ratio, incompressibility));
            double inner = 0.0, outer = 0.0;
            for (int row = 1; row < 10; ++row)
                for (int column = 0; column < 50; ++column) {
                    const double x = 0.01 * column + 0.005;
                    double& largest = x < face ? inner : outer;
                    largest = std::max(largest, std::abs(truth.stress(x, -0.05 * row).xx));
                }
            EXPECT_GT(inner, 3e5);
            EXPECT_LT(inner, 1e7);
            EXPECT_GT(outer, 3e5);
            EXPECT_LT(outer, 1e7);
        }
}

TEST(ManufacturedStrip, BodyForceBalancesTheStress) {
    const ManufacturedStrip truth(strip(100.0, 1000.0));
    for (const double x : {-0.3, -0.05, 0.06, 0.21, 0.77})
        for (const double y : {-0.3, -0.1})
            EXPECT_LT((truth.body_force(x, y) - minus_divergence(truth, x, y, 1e-3)).norm(), 1.0)
                << "of some 1e7: truncation " << x;
    const Vector2d both =
        0.5 * (truth.inner().body_force(face, -0.2) + truth.outer().body_force(face, -0.2));
    EXPECT_EQ(truth.body_force(face, -0.2), both);
}

TEST(ManufacturedStrip, IsClampedSymmetricAndPeriodic) {
    const ManufacturedStrip truth(strip(100.0, 1000.0));
    for (const double x : {0.07, 0.3}) {
        EXPECT_EQ(truth.displacement(x, -0.5).norm(), 0.0);
        const Vector2d right = truth.displacement(x, -0.1);
        const Vector2d left = truth.displacement(-x, -0.1);
        EXPECT_EQ(left.x(), -right.x());
        EXPECT_EQ(left.y(), right.y());
        EXPECT_LT((truth.displacement(x + 1.0, -0.1) - right).norm(), 1e-14 * right.norm() + 1e-16);
    }
    EXPECT_NEAR(truth.displacement(0.0, -0.1).x(), 0.0, 1e-16);
    EXPECT_NEAR(truth.displacement(0.5, -0.1).x(), 0.0, 1e-16);
    EXPECT_NEAR(truth.stress(0.5, -0.1).xy, 0.0, 1e-6);
}

TEST(ManufacturedStrip, RefusesBadInput) {
    ElasticStrip wide = strip(1.0, 1.0);
    wide.strip = 1.0;
    EXPECT_THROW(ManufacturedStrip{wide}, std::invalid_argument);
    ElasticStrip soft = strip(1.0, 1.0);
    soft.inner.shear = 0.0;
    EXPECT_THROW(ManufacturedStrip{soft}, std::invalid_argument);
    ElasticStrip unloaded = strip(1.0, 1.0);
    unloaded.stress = missing;
    EXPECT_THROW(ManufacturedStrip{unloaded}, std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
