/// A made-up displacement of two bonded strips, with its loads.
#pragma once

#include <Eigen/Core>

#include "reference/manufactured_elasticity.hpp"

namespace crawford::reference {

/// A strip of one material, |x| < strip/2, between another; periodic in x, symmetric about the
/// middle of each; clamped at y = -depth, flat on top, y = 0.
struct ElasticStrip {
    double width = missing;  ///< one period [m]
    double strip = missing;  ///< [m]
    double depth = missing;  ///< [m]
    ElasticModuli outer, inner;
    double stress = missing;  ///< size of the stress in both materials [Pa]

    /// \throws std::invalid_argument naming the parameter that is missing or out of range.
    void require() const;
};

/// A displacement that is continuous across both faces of a strip, as is its traction, and smooth
/// in each material: the stress has one size in both, however different their moduli, and is
/// bounded as K/mu grows, where the displacement becomes incompressible.
///
/// In a material with shear modulus mu, u = psi_y + q and v = -psi_x. At a face, a distance d off,
///     psi = P0(y) + P1(y) d + (P0'' - tau/mu) d^2/2 + ...,
///     q = (sigma - 2 mu P1')/(lambda + 2 mu) d + ...
/// so that sigma_11 = sigma(y) and sigma_12 = tau(y) on either side. The series continue as
/// combinations of sines that are odd about the middle of the material.
class ManufacturedStrip {
public:
    /// \throws std::invalid_argument \see ElasticStrip::require
    explicit ManufacturedStrip(const ElasticStrip& strip);

    Eigen::Vector2d displacement(double x, double y) const;  ///< [m]
    /// [Pa]; on a face the mean of both sides.
    PlaneStrainStress stress(double x, double y) const;
    /// b = -div sigma [N/m^3]; on a face the mean of both sides, which is what a trapezoidal rule
    /// over cells of either side adds up to.
    Eigen::Vector2d body_force(double x, double y) const;

    /// One material by itself, for 0 <= x <= width/2; smooth across its face.
    const ManufacturedElasticity& outer() const { return outer_; }
    const ManufacturedElasticity& inner() const { return inner_; }

private:
    /// x folded into 0 <= x <= width/2, and the sign of what is odd about the folds.
    struct Folded {
        double x, sign;
    };
    Folded fold(double x) const;
    /// What `of` gives for the material at x, or the mean where it is on the face.
    template <class Of>
    auto side(double x, const Of& of) const;

    double width_, face_;
    ManufacturedElasticity outer_, inner_;
};

}  // namespace crawford::reference
