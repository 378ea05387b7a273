/// Stress and body force of a made-up displacement.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "reference/derivatives.hpp"
#include "reference/material.hpp"
#include "reference/plane_strain_stress.hpp"

namespace crawford::reference {

/// Stiffness of an isotropic solid.
struct ElasticModuli {
    double bulk = missing;   ///< K [Pa]
    double shear = missing;  ///< mu [Pa]

    double lame() const { return bulk - 2.0 * shear / 3.0; }  ///< lambda [Pa]
    /// \throws std::invalid_argument naming the modulus that is missing or not positive.
    void require() const;
};

/// A displacement somebody has chosen, and the loads under which it is the exact one: plane strain,
/// small-strain linear elasticity, one material, div sigma + b = 0. The second derivatives that b
/// needs come from automatic differentiation.
class ManufacturedElasticity {
public:
    /// \param displacement (x, y) -> std::array<scalar, 2> [m], templated on the scalar
    /// \throws std::invalid_argument \see ElasticModuli::require
    template <class Displacement>
    ManufacturedElasticity(Displacement displacement, const ElasticModuli& moduli)
        : moduli_(moduli), at_([field = std::move(displacement)](double x, double y) {
              return derivatives(field, x, y);
          }) {
        moduli_.require();
    }

    Eigen::Vector2d displacement(double x, double y) const;  ///< [m]
    PlaneStrainStress stress(double x, double y) const;      ///< [Pa]
    Eigen::Vector2d body_force(double x, double y) const;    ///< b = -div sigma [N/m^3]

private:
    ElasticModuli moduli_;
    std::function<std::array<Derivatives, 2>(double x, double y)> at_;
};

/// sigma.n [Pa] on a surface of this slope, n outward and upward.
Eigen::Vector2d traction(const PlaneStrainStress& stress, double slope);

}  // namespace crawford::reference
