#include "reference/faded_inclusion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

FadedInclusion::FadedInclusion(const CircularInclusion& inclusion, double whole, double gone)
    : inclusion_(inclusion), whole_(whole), gone_(gone) {
    require_positive("whole", whole);
    require_positive("gone", gone);
    const double radius = inclusion.conditions().radius;
    if (whole <= radius)
        throw std::invalid_argument(
            fmt::format("whole = {} must be more than the radius, {}", whole, radius));
    if (gone <= whole)
        throw std::invalid_argument(
            fmt::format("gone = {} must be more than whole, {}", gone, whole));
}

/// chi = 1 - t^4 (35 - 84 t + 70 t^2 - 20 t^3), t from 0 at `whole` to 1 at `gone`.
FadedInclusion::Fade FadedInclusion::fade(double x, double y) const {
    const double r = std::hypot(x, y);
    if (r <= whole_) return {1.0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    if (r >= gone_) return {0.0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    const double width = gone_ - whole_;
    const double t = (r - whole_) / width;
    const double s = 1.0 - t;
    const double first = -140.0 * std::pow(t * s, 3) / width;
    const double second = -420.0 * t * t * s * s * (s - t) / (width * width);
    const Eigen::Vector2d outward(x / r, y / r);
    const Eigen::Matrix2d along = outward * outward.transpose();
    return {1.0 - std::pow(t, 4) * (35.0 - 84.0 * t + 70.0 * t * t - 20.0 * t * t * t),
            first * outward, second * along + first / r * (Eigen::Matrix2d::Identity() - along)};
}

Eigen::Vector2d FadedInclusion::displacement(double x, double y) const {
    return fade(x, y).value * inclusion_.displacement(x, y);
}

PlaneStrainStress FadedInclusion::stress(double x, double y) const {
    const Fade chi = fade(x, y);
    PlaneStrainStress sigma = inclusion_.stress(x, y);
    if (chi.value == 1.0) return sigma;
    const Material& matrix = inclusion_.conditions().matrix;
    const Eigen::Matrix2d extra = inclusion_.displacement(x, y) * chi.gradient.transpose();
    const double volumetric = matrix.lame() * extra.trace();
    const double twice = 2.0 * matrix.shear_modulus;
    return {.xx = chi.value * sigma.xx + volumetric + twice * extra(0, 0),
            .yy = chi.value * sigma.yy + volumetric + twice * extra(1, 1),
            .zz = chi.value * sigma.zz + volumetric,
            .xy = chi.value * sigma.xy + 0.5 * twice * (extra(0, 1) + extra(1, 0))};
}

Eigen::Vector2d FadedInclusion::body_force(double x, double y) const {
    const Fade chi = fade(x, y);
    const Material& matrix = inclusion_.conditions().matrix;
    const Eigen::Vector2d u = inclusion_.displacement(x, y);
    const Eigen::Matrix2d g = inclusion_.gradient(x, y);
    const PlaneStrainStress s = inclusion_.stress(x, y);
    Eigen::Matrix2d sigma;
    sigma << s.xx, s.xy, s.xy, s.yy;
    const Eigen::Vector2d bend = chi.hessian * u;
    return -(sigma * chi.gradient + matrix.lame() * (g.transpose() * chi.gradient + bend) +
             matrix.shear_modulus *
                 (g * chi.gradient + chi.hessian.trace() * u + bend + g.trace() * chi.gradient));
}

}  // namespace crawford::reference
