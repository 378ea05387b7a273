/// What a steadily burning slab is made of and under what it burns.
#pragma once

#include <limits>

#include "reference/material.hpp"

namespace crawford::reference {

/// How stress and mass enter the steady energy equation of a homogeneous burning slab. With D = T -
/// T0, theta = beta/P and a prime for d/dy:
enum class SlabModel {
    thermal,            ///< kappa T'' = rho c_p r_b T': nothing expands
    kuznetsov_stewart,  ///< small strain, v' = theta r_b T' (paper eq. 50-53 with the last term of
                        ///< eq. 50 a sink)
    eulerian,  ///< constant rho carried by r_b + v, v' = theta (r_b + v) T': the equations the
               ///< solver solves
    mass_conserving,  ///< as eulerian, but rho (r_b + v) keeps its cold value
};

/// Which modulus multiplies DT/Dt in the stress equation.
enum class ThermalStress {
    alpha_k,        ///< beta = alpha K, paper eq. 50-53
    three_alpha_k,  ///< beta = 3 alpha K, paper eq. 38
};

/// Which specific heat stands before DT/Dt. Expansion that is free to happen takes beta^2 T/K of
/// heat per volume and degree, through the stress work; a capacity at constant pressure has it
/// already.
enum class HeatCapacity {
    constant_pressure,  ///< c = c_p, as the paper: what expansion takes comes on top of it
    constant_volume     ///< c = c_p - beta^2 T/(rho K), rho that of the solid where it is
};

/// What sets the speed of the surface.
enum class Regression {
    prescribed,  ///< r_b is given
    pyrolysis,   ///< r_b = A exp(-Ea/(R T_s))
};

/// A homogeneous half space or layer that burns steadily, seen from its surface: y <= 0, solid
/// comes up with speed r_b, and kappa T' = Q + q_s rho r_b enters at y = 0. What has no default
/// must be given.
struct SlabConditions {
    Material material{};
    SlabModel model = SlabModel::eulerian;
    ThermalStress thermal_stress = ThermalStress::three_alpha_k;
    HeatCapacity heat_capacity = HeatCapacity::constant_pressure;
    Regression regression = Regression::prescribed;
    double heat_flux = missing;         ///< Q [W/m^2], from the flame
    double burn_rate = missing;         ///< r_b [m/s]; read if prescribed
    double pressure = missing;          ///< p_c [Pa] on the surface
    double cold_temperature = missing;  ///< T0 [K], far below or at y = -depth
    /// T = T0 at y = -depth [m], or infinitely deep.
    double depth = std::numeric_limits<double>::infinity();
};

/// Refuses conditions no steady slab obeys.
/// \throws std::invalid_argument naming the missing or out-of-range parameter.
void require_valid(const SlabConditions& conditions);

/// beta [Pa/K] of the material as these conditions read it; 0 for SlabModel::thermal.
double thermal_stress_modulus(const SlabConditions& conditions);

/// How much of the stress work counts beside c_p: all of it, or, where c_p - c_v is given back, the
/// share 1 - P/K = -4 mu/(3 K), with which confinement falls short of free expansion.
double counted_stress_work(const SlabConditions& conditions);

/// r_b [m/s] at surface temperature T_s [K]: the prescribed one, or the pyrolysis law.
double burn_rate_at(const SlabConditions& conditions, double surface_temperature);

/// A height [m] inside the slab: y itself, moved onto the bottom where only rounding put it below.
/// \throws std::invalid_argument for a point above the surface or below the bottom.
double height_within(const SlabConditions& conditions, double y);

}  // namespace crawford::reference
