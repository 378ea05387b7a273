/// A slab that burns steadily, in closed form up to a quadrature.
#pragma once

#include <span>
#include <vector>

#include "reference/slab_conditions.hpp"
#include "reference/slab_energy.hpp"

namespace crawford::reference {

/// Everything known at one depth of a steady slab.
struct SlabState {
    double temperature;           ///< T [K]
    double temperature_gradient;  ///< dT/dy [K/m]
    /// v [m/s] of the solid above its cold speed: D y/Dt = r_b + v. r_b expm1(theta D) in a body
    /// that deforms finitely (eulerian, mass_conserving), r_b theta D at small strain
    /// (kuznetsov_stewart), 0 where nothing expands (thermal).
    double velocity;
    double stress_11;  ///< -(lambda/P) p_c - 2 mu theta D [Pa]
    double stress_22;  ///< -p_c everywhere [Pa]
    double stress_33;  ///< as stress_11 [Pa]
    double pressure;   ///< -(trace of stress)/3 [Pa]
    /// F22. Finite deformation: exp(theta D), relative to the incoming material, which is already
    /// pressed by p_c (a reference map that enters the window as xi_2 = y has no memory of that).
    /// Kuznetsov-Stewart: 1 + theta D - p_c/P, relative to stress-free material. Thermal: 1.
    double deformation_gradient_22;
    double rise;  ///< T - T0 [K], which far below is less than T tells apart from T0
};

/// The homogeneous steady burning slab in closed form: T_s from kappa T' = r_b g(D) + C at the
/// surface, y(T) from the integral of kappa dT/(r_b g + C), inverted. Accurate to about 1e-13
/// relative in T; a profile of 300 points takes a few milliseconds.
///
/// Coordinates: y <= 0, measured from the surface. Every function of y throws std::invalid_argument
/// for a point above the surface or below the bottom.
class Slab {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit Slab(const SlabConditions& conditions);

    const SlabConditions& conditions() const { return conditions_; }
    double surface_temperature() const;                  ///< T_s [K]
    double burn_rate() const { return burn_rate_; }      ///< r_b [m/s]
    double bottom_flux() const { return bottom_flux_; }  ///< C [W/m^2], out through y = -depth

    double temperature(double y) const;  ///< T [K] at y [m]
    /// All that is known at one depth y [m].
    SlabState state(double y) const;
    /// At many depths, in any order; much cheaper than one by one.
    std::vector<SlabState> states(std::span<const double> y) const;

private:
    void solve_surface(double bottom_flux);
    void solve_bottom();
    double slope_in_log(double w) const;
    double rise_at(double w) const;
    double climb(double from, double to) const;
    double descend(double w, double y_above, double y) const;
    SlabState state_at_rise(double rise) const;

    SlabConditions conditions_;
    SlabEnergy energy_;
    double bottom_flux_ = 0.0;
    double burn_rate_ = 0.0;
    double surface_rise_ = 0.0;  // T_s - T0 [K]
    double log_offset_ = 0.0;    // D = exp(w) - log_offset_ [K]
};

}  // namespace crawford::reference
