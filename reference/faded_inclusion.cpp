#include "reference/faded_inclusion.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace crawford::reference {

FadedInclusion::FadedInclusion(const CircularInclusion& inclusion, double whole, double gone)
    : inclusion_(inclusion), fade_(whole, gone) {
    const double radius = inclusion.conditions().radius;
    if (whole <= radius)
        throw std::invalid_argument(
            fmt::format("whole = {} must be more than the radius, {}", whole, radius));
}

Eigen::Vector2d FadedInclusion::displacement(double x, double y) const {
    return fade_.at(x, y).value * inclusion_.displacement(x, y);
}

PlaneStrainStress FadedInclusion::stress(double x, double y) const {
    const Fade::Value chi = fade_.at(x, y);
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
    const Fade::Value chi = fade_.at(x, y);
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
