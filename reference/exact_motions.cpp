#include "reference/exact_motions.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

namespace {

Eigen::Matrix2d matrix(double a, double b, double c, double d) {
    return (Eigen::Matrix2d() << a, b, c, d).finished();
}

Eigen::Matrix2d turned(double angle) {
    return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

}  // namespace

RigidRotation::RigidRotation(double rate, const Eigen::Vector2d& centre)
    : rate_(rate), centre_(centre) {
    require_finite("angular velocity", rate);
    require_finite("x of the centre", centre.x());
    require_finite("y of the centre", centre.y());
}

Eigen::Vector2d RigidRotation::velocity(const Eigen::Vector2d& x) const {
    const Eigen::Vector2d arm = x - centre_;
    return rate_ * Eigen::Vector2d(-arm.y(), arm.x());
}

Eigen::Vector2d RigidRotation::origin(const Eigen::Vector2d& x, double t) const {
    return centre_ + turned(-rate_ * t) * (x - centre_);
}

Eigen::Matrix2d RigidRotation::deformation_gradient(double t) const {
    return turned(rate_ * t);
}

Eigen::Matrix2d RigidRotation::stress(const Eigen::Matrix2d& initial, double t) const {
    return turned(rate_ * t) * initial * turned(-rate_ * t);
}

Eigen::Matrix2d RigidRotation::stress_rate(const Eigen::Matrix2d& stress) const {
    const Eigen::Matrix2d spin = matrix(0.0, -rate_, rate_, 0.0);
    return spin * stress - stress * spin;
}

SimpleShear::SimpleShear(double rate, double base) : rate_(rate), base_(base) {
    require_finite("shear rate", rate);
    require_finite("base", base);
}

Eigen::Vector2d SimpleShear::velocity(const Eigen::Vector2d& x) const {
    return {rate_ * (x.y() - base_), 0.0};
}

Eigen::Vector2d SimpleShear::origin(const Eigen::Vector2d& x, double t) const {
    return {x.x() - rate_ * t * (x.y() - base_), x.y()};
}

Eigen::Matrix2d SimpleShear::deformation_gradient(double t) const {
    return matrix(1.0, rate_ * t, 0.0, 1.0);
}

Eigen::Matrix2d SimpleShear::strain(double t) const {
    const double gamma = rate_ * t;
    return 0.5 * matrix(0.0, gamma, gamma, gamma * gamma);
}

Eigen::Matrix2d SimpleShear::stress(double shear_modulus, double t) const {
    require_positive("shear modulus", shear_modulus);
    const double gamma = rate_ * t;
    const double normal = 1.0 - std::cos(gamma);
    return shear_modulus * matrix(normal, std::sin(gamma), std::sin(gamma), -normal);
}

UniaxialFlow::UniaxialFlow(double speed, double base, double length)
    : speed_(speed), base_(base), length_(length) {
    require_finite("speed", speed);
    require_finite("base", base);
    require_positive("length", length);
}

double UniaxialFlow::height(const Eigen::Vector2d& x) const {
    require_not_negative("height above the base", x.y() - base_);
    return (x.y() - base_) / length_;
}

/// q/q(xi): the square root of F_22.
double UniaxialFlow::stretch(const Eigen::Vector2d& x, double t) const {
    const double ratio = 1.0 + height(x) * speed_ * t / length_;
    if (!(ratio > 0.0))
        throw std::invalid_argument(fmt::format(
            "no particle reaches y = {} in {} s: the flow comes from infinity", x.y(), t));
    return ratio;
}

Eigen::Vector2d UniaxialFlow::velocity(const Eigen::Vector2d& x) const {
    const double q = height(x);
    return {0.0, speed_ * q * q};
}

Eigen::Vector2d UniaxialFlow::origin(const Eigen::Vector2d& x, double t) const {
    return {x.x(), base_ + length_ * height(x) / stretch(x, t)};
}

Eigen::Matrix2d UniaxialFlow::deformation_gradient(const Eigen::Vector2d& x, double t) const {
    return matrix(1.0, 0.0, 0.0, std::pow(stretch(x, t), 2));
}

Eigen::Matrix2d UniaxialFlow::strain(const Eigen::Vector2d& x, double t) const {
    return matrix(0.0, 0.0, 0.0, 0.5 * (std::pow(stretch(x, t), 4) - 1.0));
}

WavyShear::WavyShear(double drift, double speed, double period)
    : drift_(drift), speed_(speed), wave_number_(2.0 * std::numbers::pi / period) {
    require_finite("drift", drift);
    require_finite("speed", speed);
    require_positive("period", period);
}

Eigen::Vector2d WavyShear::velocity(const Eigen::Vector2d& x) const {
    return {drift_, speed_ * std::sin(wave_number_ * x.x())};
}

double WavyShear::risen(double x, double t) const {
    const double half_way = 0.5 * drift_ * t;
    return t * speed_ * boost::math::sinc_pi(wave_number_ * half_way) *
           std::sin(wave_number_ * (x - half_way));
}

double WavyShear::slope(double x, double t) const {
    const double half_way = 0.5 * drift_ * t;
    return t * speed_ * boost::math::sinc_pi(wave_number_ * half_way) * wave_number_ *
           std::cos(wave_number_ * (x - half_way));
}

Eigen::Vector2d WavyShear::origin(const Eigen::Vector2d& x, double t) const {
    return {x.x() - drift_ * t, x.y() - risen(x.x(), t)};
}

Eigen::Matrix2d WavyShear::deformation_gradient(const Eigen::Vector2d& x, double t) const {
    return matrix(1.0, 0.0, slope(x.x(), t), 1.0);
}

Eigen::Matrix2d WavyShear::strain(const Eigen::Vector2d& x, double t) const {
    const double s = slope(x.x(), t);
    return 0.5 * matrix(s * s, s, s, 0.0);
}

}  // namespace crawford::reference
