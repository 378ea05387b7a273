#pragma once

#include "reference/slab_conditions.hpp"

namespace crawford::reference {

/// The steady energy equation of a slab, integrated once: kappa T' = r_b g(D) + C with D = T - T0.
///
///     thermal            g = rho c_p D
///     Kuznetsov-Stewart  g = rho c_p D + beta theta (T^2 - T0^2)/2
///     Eulerian           g = (rho c_p + beta theta T0 - beta) expm1(theta D)/theta
///                            + beta D exp(theta D)
///     mass conserving    g = rho c_p D + (beta theta T0 - beta) expm1(theta D)/theta
///                            + beta D exp(theta D)
///
/// C is the heat that leaves through the bottom of a layer of finite depth, 0 in a half space.
class SlabEnergy {
public:
    explicit SlabEnergy(const SlabConditions& conditions);

    /// g(D) [J/m^3]: heat stored and spent per unit volume that has come up, D [K].
    double heat_content(double rise) const;

    /// g'(0) [J/(m^3 K)]: capacity of the cold solid, its thermal stress included.
    double cold_capacity() const { return rho_c_ + beta_ * theta_ * cold_; }

    /// theta = beta/P [1/K].
    double theta() const { return theta_; }

private:
    SlabModel model_;
    double rho_c_;  // rho c_p [J/(m^3 K)]
    double beta_;   // [Pa/K]
    double theta_;  // [1/K]
    double cold_;   // T0 [K]
};

}  // namespace crawford::reference
