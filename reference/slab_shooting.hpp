/// The steadily burning slab by shooting.
#pragma once

#include <span>
#include <vector>

#include "reference/slab_conditions.hpp"

namespace crawford::reference {

/// One point of a slab found by shooting.
struct ShotState {
    double temperature;  ///< T [K]
    double velocity;     ///< v [m/s]
    double stress_11;    ///< [Pa]
};

/// The homogeneous steady burning slab once more, by another road: the differential equations
///
///     kappa T'' = (mass carried) c T' + beta T v',   sigma_22' = 0 (which gives v'),   sigma_11'
///
/// are integrated from the cold side with an adaptive Bulirsch-Stoer method (Boost.Odeint), and the
/// slope at the bottom (and r_b, under the burning law) is varied until the flux at the surface is
/// right. Nothing of the closed form is used; the two agree to 1e-10.
///
/// In a half space the integration starts 30 e-foldings below the surface on the cold solution,
/// D ~ exp(m y).
class SlabShooting {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit SlabShooting(const SlabConditions& conditions);

    double surface_temperature() const { return surface_temperature_; }  ///< T_s [K]
    double burn_rate() const { return burn_rate_; }                      ///< r_b [m/s]

    /// States at the depths y [m] <= 0, in any order.
    /// \throws std::invalid_argument for a point above the surface or below the bottom.
    std::vector<ShotState> states(std::span<const double> y) const;

private:
    double shoot(double burn_rate);

    SlabConditions conditions_;
    double surface_temperature_ = 0.0;
    double burn_rate_ = 0.0;
    double log_slope_ = 0.0;  // ln of kappa T' at the start over the flux at the surface
};

}  // namespace crawford::reference
