#include "reference/circular_inclusion.hpp"

#include "reference/require.hpp"

namespace crawford::reference {

namespace {

/// Kolosov's constant 3 - 4 nu.
double kolosov(const Material& material) {
    return 1.0 + 2.0 * material.shear_modulus / (material.lame() + material.shear_modulus);
}

}  // namespace

CircularInclusion::CircularInclusion(const InclusionConditions& conditions)
    : conditions_(conditions),
      kappa_inclusion_(kolosov(conditions.inclusion)),
      kappa_matrix_(kolosov(conditions.matrix)),
      gamma_(0.25 * (conditions.far_xx + conditions.far_yy)),
      gamma_prime_(0.5 * (conditions.far_yy - conditions.far_xx), conditions.far_xy) {
    require_positive("radius", conditions.radius);
    require_positive("bulk modulus of the inclusion", conditions.inclusion.bulk_modulus);
    require_positive("shear modulus of the inclusion", conditions.inclusion.shear_modulus);
    require_positive("bulk modulus of the matrix", conditions.matrix.bulk_modulus);
    require_positive("shear modulus of the matrix", conditions.matrix.shear_modulus);
    require_finite("far_xx", conditions.far_xx);
    require_finite("far_yy", conditions.far_yy);
    require_finite("far_xy", conditions.far_xy);

    // On the circle, powers z and 1/z of traction and displacement; E = R^2 B from z^-3 of both.
    const double square = conditions.radius * conditions.radius;
    const double inside = conditions.inclusion.shear_modulus;
    const double outside = conditions.matrix.shear_modulus;
    a_ = gamma_ * (kappa_matrix_ + 1.0) / (2.0 + outside / inside * (kappa_inclusion_ - 1.0));
    d_ = 2.0 * square * (a_ - gamma_);
    b_ = square * std::conj(gamma_prime_) * (inside - outside) / (kappa_matrix_ * inside + outside);
    c_ = std::conj(b_) / square + gamma_prime_;
}

CircularInclusion::Potentials CircularInclusion::at(Complex z) const {
    if (std::abs(z) <= conditions_.radius)
        return {.phi = a_ * z,
                .phi_slope = a_,
                .phi_curvature = 0.0,
                .psi = c_ * z,
                .psi_slope = c_,
                .kappa = kappa_inclusion_,
                .shear_modulus = conditions_.inclusion.shear_modulus};
    const Complex square = z * z;
    const Complex e = conditions_.radius * conditions_.radius * b_;
    return {.phi = gamma_ * z + b_ / z,
            .phi_slope = gamma_ - b_ / square,
            .phi_curvature = 2.0 * b_ / (square * z),
            .psi = gamma_prime_ * z + d_ / z + e / (square * z),
            .psi_slope = gamma_prime_ - d_ / square - 3.0 * e / (square * square),
            .kappa = kappa_matrix_,
            .shear_modulus = conditions_.matrix.shear_modulus};
}

Eigen::Vector2d CircularInclusion::displacement(double x, double y) const {
    const Complex z(x, y);
    const Potentials p = at(z);
    const Complex w =
        (p.kappa * p.phi - z * std::conj(p.phi_slope) - std::conj(p.psi)) / (2.0 * p.shear_modulus);
    return {w.real(), w.imag()};
}

Eigen::Matrix2d CircularInclusion::gradient(double x, double y) const {
    const Complex z(x, y);
    const Potentials p = at(z);
    const double compliance = 1.0 / (2.0 * p.shear_modulus);
    const Complex along_z = compliance * (p.kappa * p.phi_slope - std::conj(p.phi_slope));
    const Complex along_conjugate =
        -compliance * (z * std::conj(p.phi_curvature) + std::conj(p.psi_slope));
    const Complex along_x = along_z + along_conjugate;
    const Complex along_y = Complex(0.0, 1.0) * (along_z - along_conjugate);
    Eigen::Matrix2d result;
    result << along_x.real(), along_y.real(), along_x.imag(), along_y.imag();
    return result;
}

PlaneStrainStress CircularInclusion::stress(double x, double y) const {
    const Complex z(x, y);
    const Potentials p = at(z);
    const double sum = 4.0 * p.phi_slope.real();                                // yy + xx
    const Complex turn = 2.0 * (std::conj(z) * p.phi_curvature + p.psi_slope);  // yy - xx + 2i xy
    const double poisson = 0.25 * (3.0 - p.kappa);
    return {.xx = 0.5 * (sum - turn.real()),
            .yy = 0.5 * (sum + turn.real()),
            .zz = poisson * sum,
            .xy = 0.5 * turn.imag()};
}

}  // namespace crawford::reference
