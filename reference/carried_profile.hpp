/// Scalar profiles that a motion carries: c X(x) Y(y), smooth, with their gradients.
#pragma once

#include <Eigen/Core>

namespace crawford::reference {

/// How a profile varies along a column.
enum class ColumnShape {
    constant,     ///< Y = 1
    exponential,  ///< Y = exp((y - y0)/w): convex and monotone, no derivative has a zero
    bump          ///< Y = exp(-((y - y0)/w)^2): one maximum and two inflections
};

/// X = cos(2 pi x/L + phase), or cos(phase) everywhere where L is zero.
struct ProfileShape {
    double amplitude = 1.0;  ///< c, in the unit of what is carried
    double period = 0.0;     ///< L [m], >= 0
    double phase = 0.0;      ///< [rad]
    ColumnShape column = ColumnShape::constant;
    double middle = 0.0;  ///< y0 [m]
    double width = 1.0;   ///< w [m], > 0
};

class CarriedProfile {
public:
    /// \throws std::invalid_argument naming the parameter that is missing or not in its range.
    explicit CarriedProfile(const ProfileShape& shape);

    double value(const Eigen::Vector2d& x) const;
    Eigen::Vector2d gradient(const Eigen::Vector2d& x) const;

    /// What a point that moves with `point` [m/s] sees per second while `material` [m/s] carries
    /// the profile past it: -(material - point).grad.
    double rate(const Eigen::Vector2d& x, const Eigen::Vector2d& material,
                const Eigen::Vector2d& point) const;

private:
    ProfileShape shape_;
    double wave_number_ = 0.0;
};

}  // namespace crawford::reference
