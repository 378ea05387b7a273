/// The energy equation of a steadily burning slab, once integrated.
#pragma once

#include "reference/slab_conditions.hpp"

namespace crawford::reference {

/// The steady energy equation of a slab, integrated once: kappa T' = r_b g(D) + C with D = T - T0.
///
///     thermal            g = rho c_p D
///     Kuznetsov-Stewart  g = rho c_p D + s W,   W = beta theta (T^2 - T0^2)/2
///     Eulerian           g = rho c_p expm1(theta D)/theta + s W
///     mass conserving    g = rho c_p D + s W,
///                            W = beta (theta T0 - 1) expm1(theta D)/theta + beta D exp(theta D)
///
/// W, the integral of beta theta T exp(theta D) in the last two, is the stress work of a solid that
/// cannot widen. s = 1 where c = c_p. Where c = c_v, the stored heat is less by the integral of
/// beta^2 T/K exp(theta D), which is (P/K) W, so that s = 1 - P/K = -4 mu/(3 K): a solid without
/// shear modulus takes c_p and nothing else, and a stiff one a little less, because it may not
/// expand as far as it would.
///
/// C is the heat that leaves through the bottom of a layer of finite depth, 0 in a half space.
class SlabEnergy {
public:
    explicit SlabEnergy(const SlabConditions& conditions);

    /// g(D) [J/m^3]: heat stored and spent per unit volume that has come up, D [K].
    double heat_content(double rise) const;

    /// g'(0) [J/(m^3 K)]: capacity of the cold solid, its thermal stress included.
    double cold_capacity() const { return rho_c_ + counted_work_ * beta_ * theta_ * cold_; }

    /// D [K] beyond which the solid would take no more heat, g' = 0; infinite at constant pressure.
    double largest_rise() const;

    /// theta = beta/P [1/K].
    double theta() const { return theta_; }

private:
    SlabModel model_;
    double rho_c_;         // rho c_p [J/(m^3 K)]
    double beta_;          // [Pa/K]
    double theta_;         // [1/K]
    double counted_work_;  // s
    double cold_;          // T0 [K]
};

}  // namespace crawford::reference
