/// Motions whose particles can be followed in closed form, with the strain and the stress they
/// leave.
///
/// Each is steady: v(x) does not change with time, so that the place xi(x, t) where the particle
/// now at x started obeys xi_t = -v(xi) as well as D(xi)/Dt = 0. F = d(x)/d(xi), E = (F^T F - I)/2.
/// SI units.
#pragma once

#include <Eigen/Core>

namespace crawford::reference {

/// The body turns about a point, counter-clockwise. Nothing is strained; by the Jaumann rate, as by
/// every objective rate, the stress turns with the body.
class RigidRotation {
public:
    /// \param rate angular velocity [rad/s]; negative is clockwise
    /// \throws std::invalid_argument if the rate or the centre is missing or infinite.
    RigidRotation(double rate, const Eigen::Vector2d& centre);

    Eigen::Vector2d velocity(const Eigen::Vector2d& x) const;          ///< [m/s]
    Eigen::Vector2d origin(const Eigen::Vector2d& x, double t) const;  ///< xi [m]
    Eigen::Matrix2d deformation_gradient(double t) const;              ///< R(rate t)
    /// The in-plane stress at time t of a particle that started with `initial`: R S R^T.
    Eigen::Matrix2d stress(const Eigen::Matrix2d& initial, double t) const;
    /// Its material rate W S - S W, W the spin.
    Eigen::Matrix2d stress_rate(const Eigen::Matrix2d& stress) const;

private:
    double rate_;
    Eigen::Vector2d centre_;
};

/// Layers slide over each other, v = (gamma_t (y - y0), 0), from a state without stress. A
/// hypoelastic solid under the Jaumann rate answers with a stress that oscillates
/// (Dienes 1979): tau = mu sin(gamma), sigma_11 = -sigma_22 = mu (1 - cos(gamma)).
class SimpleShear {
public:
    /// \param rate gamma_t [1/s]
    /// \param base y0 [m], the layer that stays
    /// \throws std::invalid_argument if one of them is missing or infinite.
    SimpleShear(double rate, double base);

    Eigen::Vector2d velocity(const Eigen::Vector2d& x) const;          ///< [m/s]
    Eigen::Vector2d origin(const Eigen::Vector2d& x, double t) const;  ///< xi [m]
    Eigen::Matrix2d deformation_gradient(double t) const;
    Eigen::Matrix2d strain(double t) const;
    /// Cauchy stress in the plane [Pa] of a solid with this shear modulus [Pa]; sigma_33 = 0.
    /// \throws std::invalid_argument unless the modulus is positive.
    Eigen::Matrix2d stress(double shear_modulus, double t) const;

private:
    double rate_, base_;
};

/// The material streams upward and stretches: v = V q^2, q = (y - y0)/L above the layer y0 that
/// stays. xi is curved in y: 1/q(xi) = 1/q + V t/L and F_22 = (q/q(xi))^2.
class UniaxialFlow {
public:
    /// \param speed V [m/s]: the velocity a length L above the base
    /// \param base y0 [m]
    /// \throws std::invalid_argument if one is missing, infinite or, for L, not positive.
    UniaxialFlow(double speed, double base, double length);

    /// \throws std::invalid_argument below the base.
    Eigen::Vector2d velocity(const Eigen::Vector2d& x) const;  ///< [m/s]
    /// \throws std::invalid_argument below the base, or where no particle has arrived by t.
    Eigen::Vector2d origin(const Eigen::Vector2d& x, double t) const;  ///< xi [m]
    Eigen::Matrix2d deformation_gradient(const Eigen::Vector2d& x, double t) const;
    Eigen::Matrix2d strain(const Eigen::Vector2d& x, double t) const;

private:
    double height(const Eigen::Vector2d& x) const;  // q
    double stretch(const Eigen::Vector2d& x, double t) const;

    double speed_, base_, length_;
};

/// Columns slide beside each other while all drift sideways, v = (U, V sin(2 pi x/L)): a shear that
/// is periodic in x and curves the map in x.
class WavyShear {
public:
    /// \param drift U [m/s]
    /// \param speed V [m/s]
    /// \param period L [m]
    /// \throws std::invalid_argument if one is missing, infinite or, for L, not positive.
    WavyShear(double drift, double speed, double period);

    Eigen::Vector2d velocity(const Eigen::Vector2d& x) const;          ///< [m/s]
    Eigen::Vector2d origin(const Eigen::Vector2d& x, double t) const;  ///< xi [m]
    Eigen::Matrix2d deformation_gradient(const Eigen::Vector2d& x, double t) const;
    Eigen::Matrix2d strain(const Eigen::Vector2d& x, double t) const;

private:
    // A particle has risen by t V sinc(k U t/2) sin(k (x - U t/2)), the mean of V sin on its way.
    double risen(double x, double t) const;
    double slope(double x, double t) const;  // F_21 = d(risen)/dx

    double drift_, speed_, wave_number_;
};

}  // namespace crawford::reference
