#include "reference/exact_motions.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/carried_profile.hpp"

namespace crawford::reference {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Each motion once, with places that its particles reach.
const RigidRotation rotation(1.3, {0.2, -0.1});
const SimpleShear shear(-0.8, 0.4);
const UniaxialFlow flow(0.7, -1.0, 0.9);
const WavyShear wavy(0.6, -0.5, 1.7);
const WavyShear standing(0.0, 0.5, 1.7);
const std::array<Vector2d, 3> places = {Vector2d(0.3, 0.2), Vector2d(-0.7, 0.6),
                                        Vector2d(1.1, -0.4)};
constexpr double t = 0.9;

template <class Check>
void for_each_motion(const Check& check) {
    check(rotation);
    check(shear);
    check(flow);
    check(wavy);
    check(standing);
}

template <class Motion>
Matrix2d deformation_gradient(const Motion& motion, const Vector2d& x, double time) {
    if constexpr (requires { motion.deformation_gradient(x, time); })
        return motion.deformation_gradient(x, time);
    else
        return motion.deformation_gradient(time);
}

/// Fourth-order central difference; rounding and truncation both stay near 1e-11.
template <class Function>
auto derivative(const Function& f, double at) -> decltype(f(at)) {
    const double h = 2e-3;
    return (8.0 * (f(at + h) - f(at - h)) - (f(at + 2 * h) - f(at - 2 * h))) / (12.0 * h);
}

TEST(ExactMotions, OriginsAreWhereTheVelocityLeadsBackTo) {
    using Place = std::array<double, 2>;
    for_each_motion([](const auto& motion) {
        for (const Vector2d& x : places) {
            Place place = {x.x(), x.y()};
            const auto backwards = [&](const Place& p, Place& rate, double) {
                const Vector2d v = motion.velocity({p[0], p[1]});
                rate = {-v.x(), -v.y()};
            };
            using namespace boost::numeric::odeint;
            integrate_const(runge_kutta_fehlberg78<Place>(), backwards, place, 0.0, t, t / 200.0);
            const Vector2d origin = motion.origin(x, t);
            EXPECT_NEAR(origin.x(), place[0], 1e-11);
            EXPECT_NEAR(origin.y(), place[1], 1e-11);
        }
    });
}

TEST(ExactMotions, DeformationGradientInvertsTheGradientOfTheOrigin) {
    for_each_motion([](const auto& motion) {
        for (const Vector2d& x : places) {
            Matrix2d gradient;
            for (int k = 0; k < 2; ++k)
                gradient.col(k) = derivative(
                    [&](double s) -> Vector2d {
                        return motion.origin(x + s * Vector2d::Unit(k), t);
                    },
                    0.0);
            const Matrix2d product = deformation_gradient(motion, x, t) * gradient;
            EXPECT_LT((product - Matrix2d::Identity()).norm(), 1e-9) << product;
        }
    });
}

TEST(ExactMotions, OriginsAreCarriedByTheMaterial) {
    // xi_t + v.grad(xi) = 0 and xi_t = -v(xi).
    for_each_motion([](const auto& motion) {
        for (const Vector2d& x : places) {
            const Vector2d rate =
                derivative([&](double s) -> Vector2d { return motion.origin(x, s); }, t);
            EXPECT_LT((rate + motion.velocity(motion.origin(x, t))).norm(), 1e-9);
            const Matrix2d f = deformation_gradient(motion, x, t);
            EXPECT_LT((rate + f.inverse() * motion.velocity(x)).norm(), 1e-9);
        }
    });
}

TEST(ExactMotions, StrainIsGreens) {
    const auto green = [](const Matrix2d& f) -> Matrix2d {
        return 0.5 * (f.transpose() * f - Matrix2d::Identity());
    };
    EXPECT_LT(green(rotation.deformation_gradient(t)).norm(), 1e-15);
    EXPECT_LT((green(shear.deformation_gradient(t)) - shear.strain(t)).norm(), 1e-15);
    for (const Vector2d& x : places) {
        EXPECT_LT((green(flow.deformation_gradient(x, t)) - flow.strain(x, t)).norm(), 1e-14);
        EXPECT_LT((green(wavy.deformation_gradient(x, t)) - wavy.strain(x, t)).norm(), 1e-14);
    }
}

/// The Jaumann rate of a stress: S_t - (W S - S W), in a uniform motion with this gradient.
Matrix2d jaumann(const Matrix2d& rate, const Matrix2d& stress, const Matrix2d& velocity_gradient) {
    const Matrix2d spin = 0.5 * (velocity_gradient - velocity_gradient.transpose());
    return rate - spin * stress + stress * spin;
}

template <class Motion>
Matrix2d velocity_gradient(const Motion& motion) {
    Matrix2d gradient;
    for (int k = 0; k < 2; ++k)
        gradient.col(k) = motion.velocity(Vector2d::Unit(k)) - motion.velocity(Vector2d::Zero());
    return gradient;
}

TEST(ExactMotions, StressTurnsWithoutAJaumannRate) {
    const Matrix2d start = (Matrix2d() << 3.0, 2.0, 2.0, -1.0).finished();
    const Matrix2d stress = rotation.stress(start, t);
    const Matrix2d rate =
        derivative([&](double s) -> Matrix2d { return rotation.stress(start, s); }, t);
    EXPECT_LT(jaumann(rate, stress, velocity_gradient(rotation)).norm(), 1e-9);
    EXPECT_LT((rate - rotation.stress_rate(stress)).norm(), 1e-9);
    EXPECT_NEAR(stress.determinant(), start.determinant(), 1e-14);
    EXPECT_NEAR(stress.trace(), start.trace(), 1e-14);
    // A quarter turn counter-clockwise brings what pulled along x to pull along y.
    const Matrix2d quarter = RigidRotation(0.5 * std::numbers::pi, {0, 0}).stress(start, 1.0);
    EXPECT_NEAR(quarter(1, 1), 3.0, 1e-14);
    EXPECT_NEAR(quarter(0, 1), -2.0, 1e-14);
}

TEST(ExactMotions, ShearedSolidIsHypoelastic) {
    const double mu = 5.0;
    const Matrix2d rate = derivative([&](double s) -> Matrix2d { return shear.stress(mu, s); }, t);
    const Matrix2d gradient = velocity_gradient(shear);
    const Matrix2d expected = mu * (gradient + gradient.transpose());
    EXPECT_LT((jaumann(rate, shear.stress(mu, t), gradient) - expected).norm(), 1e-9);
    EXPECT_EQ(shear.stress(mu, 0.0).norm(), 0.0);
}

TEST(ExactMotions, RefuseWhatIsMissingOrImpossible) {
    EXPECT_THROW(RigidRotation(missing, {0, 0}), std::invalid_argument);
    EXPECT_THROW(RigidRotation(1.0, {0, missing}), std::invalid_argument);
    EXPECT_THROW(SimpleShear(missing, 0.0), std::invalid_argument);
    EXPECT_THROW(SimpleShear(1.0, 0.0).stress(0.0, 1.0), std::invalid_argument);
    EXPECT_THROW(UniaxialFlow(1.0, 0.0, 0.0), std::invalid_argument);
    EXPECT_THROW(UniaxialFlow(1.0, 0.0, 1.0).velocity({0.0, -0.1}), std::invalid_argument);
    EXPECT_THROW(UniaxialFlow(-1.0, 0.0, 1.0).origin({0.0, 1.0}, 1.0), std::invalid_argument);
    EXPECT_THROW(WavyShear(0.0, missing, 1.0), std::invalid_argument);
    EXPECT_THROW(WavyShear(0.0, 1.0, 0.0), std::invalid_argument);
}

const std::array<ProfileShape, 3> shapes = {
    ProfileShape{.amplitude = 2.0, .period = 1.5, .phase = 0.4},
    ProfileShape{.amplitude = -3.0,
                 .phase = 0.4,
                 .column = ColumnShape::exponential,
                 .middle = 0.1,
                 .width = 0.7},
    ProfileShape{.amplitude = 1.0,
                 .period = 2.0,
                 .phase = -1.0,
                 .column = ColumnShape::bump,
                 .middle = -0.2,
                 .width = 0.8}};

TEST(CarriedProfile, GradientIsThatOfItsValues) {
    for (const ProfileShape& shape : shapes) {
        const CarriedProfile profile(shape);
        for (const Vector2d& x : places)
            for (int k = 0; k < 2; ++k)
                EXPECT_NEAR(
                    profile.gradient(x)[k],
                    derivative([&](double s) { return profile.value(x + s * Vector2d::Unit(k)); },
                               0.0),
                    1e-8);
    }
}

TEST(CarriedProfile, RateIsWhatAMovingPointSees) {
    // The profile travels with the material; the point goes its own way.
    const Vector2d material(0.3, -0.8), point(0.0, 0.5);
    for (const ProfileShape& shape : shapes) {
        const CarriedProfile profile(shape);
        for (const Vector2d& x : places) {
            const auto seen = [&](double s) { return profile.value(x + s * point - s * material); };
            EXPECT_NEAR(profile.rate(x, material, point), derivative(seen, 0.0), 1e-8);
        }
    }
}

TEST(CarriedProfile, RefusesWhatIsOutOfRange) {
    EXPECT_THROW(CarriedProfile({.amplitude = missing}), std::invalid_argument);
    EXPECT_THROW(CarriedProfile({.period = -1.0}), std::invalid_argument);
    EXPECT_THROW(CarriedProfile({.phase = missing}), std::invalid_argument);
    EXPECT_THROW(CarriedProfile({.middle = missing}), std::invalid_argument);
    EXPECT_THROW(CarriedProfile({.width = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
