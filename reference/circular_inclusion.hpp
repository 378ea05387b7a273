/// An elastic disc in an elastic matrix under a load far away.
#pragma once

#include <Eigen/Core>
#include <complex>

#include "reference/material.hpp"
#include "reference/plane_strain_stress.hpp"

namespace crawford::reference {

/// A disc in an unbounded matrix that is stressed far away.
struct InclusionConditions {
    Material inclusion, matrix;                       ///< K and mu are used
    double radius = missing;                          ///< [m]
    double far_xx = 0.0, far_yy = 0.0, far_xy = 0.0;  ///< Stress at infinity [Pa]
};

/// The perfectly bonded circular inclusion in plane strain, in closed form, about the origin.
///
/// Kolosov and Muskhelishvili: 2 mu (u + iv) = kappa phi - z conj(phi') - conj(psi), kappa = 3 - 4
/// nu. Inside phi = a z, psi = c z: the strain is even, as Eshelby found. Outside phi = Gamma z +
/// B/z, psi = Gamma' z + D/z + E/z^3, Gamma = (far_xx + far_yy)/4, Gamma' = (far_yy - far_xx)/2 +
/// i far_xy. Traction and displacement on the circle give the five coefficients. Nothing turns at
/// infinity.
class CircularInclusion {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit CircularInclusion(const InclusionConditions& conditions);

    Eigen::Vector2d displacement(double x, double y) const;  ///< (u, v) [m]
    Eigen::Matrix2d gradient(double x, double y) const;      ///< Row k: gradient of component k
    PlaneStrainStress stress(double x, double y) const;      ///< [Pa]; on the circle that inside

    const InclusionConditions& conditions() const { return conditions_; }

private:
    using Complex = std::complex<double>;
    struct Potentials {
        Complex phi, phi_slope, phi_curvature, psi, psi_slope;
        double kappa, shear_modulus;
    };
    Potentials at(Complex z) const;

    InclusionConditions conditions_;
    double kappa_inclusion_, kappa_matrix_;
    double gamma_, a_, d_;  // real: nothing turns
    Complex gamma_prime_, b_, c_;
};

}  // namespace crawford::reference
