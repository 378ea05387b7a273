#include "reference/manufactured_elasticity.hpp"

#include <cmath>

#include "reference/require.hpp"

namespace crawford::reference {

void ElasticModuli::require() const {
    require_positive("bulk modulus", bulk);
    require_positive("shear modulus", shear);
}

Eigen::Vector2d ManufacturedElasticity::displacement(double x, double y) const {
    const auto [u, v] = at_(x, y);
    return {u.value, v.value};
}

PlaneStrainStress ManufacturedElasticity::stress(double x, double y) const {
    const auto [u, v] = at_(x, y);
    const double confined = moduli_.lame() * (u.x + v.y);
    return {.xx = confined + 2.0 * moduli_.shear * u.x,
            .yy = confined + 2.0 * moduli_.shear * v.y,
            .zz = confined,
            .xy = moduli_.shear * (u.y + v.x)};
}

/// Navier's equation, -b = (lambda + mu) grad div + mu Laplacian.
Eigen::Vector2d ManufacturedElasticity::body_force(double x, double y) const {
    const auto [u, v] = at_(x, y);
    const double both = moduli_.lame() + moduli_.shear;
    return -Eigen::Vector2d{both * (u.xx + v.xy) + moduli_.shear * (u.xx + u.yy),
                            both * (u.xy + v.yy) + moduli_.shear * (v.xx + v.yy)};
}

Eigen::Vector2d traction(const PlaneStrainStress& stress, double slope) {
    const double length = std::hypot(1.0, slope);
    return {(stress.xy - slope * stress.xx) / length, (stress.yy - slope * stress.xy) / length};
}

}  // namespace crawford::reference
