/// Small disturbances of a flat burning front: their dispersion relation.
#pragma once

#include <complex>
#include <vector>

#include "reference/slab_conditions.hpp"

namespace crawford::reference {

/// The steady burning front of a rigid half space, in the numbers that its stability depends on.
struct SteadyFront {
    double burn_rate;         ///< r [m/s]
    double diffusivity;       ///< alpha = kappa/(rho c) [m^2/s]
    double cold_temperature;  ///< T_0 [K]
    double rise;              ///< dT = T_s - T_0 [K]
    double sensitivity;       ///< z = dT Ea/(R T_s^2)
    double reaction;          ///< Theta = q_s/(c dT), above zero where pyrolysis frees heat

    /// T [K] at eta [m] below the front.
    double temperature(double eta) const;
    double rate_unit() const { return burn_rate * burn_rate / diffusivity; }  ///< r^2/alpha [1/s]
    double wave_number() const { return burn_rate / diffusivity; }            ///< r/alpha [1/m]
};

/// \param conditions of a half space that burns by the pyrolysis law; the model must be thermal
/// \throws std::invalid_argument naming the missing or out-of-range parameter.
SteadyFront steady_front(const SlabConditions& conditions);

/// One shape in which a small disturbance of the flat front lives or dies. With the front at
/// a e^{i k x + sigma t} and eta counted from it, down to eta < 0,
///
///     T = T_0 + dT e^{r eta/alpha} + a (r/alpha) dT (b e^{lambda r eta/alpha} + e^{r eta/alpha}) e^{i k x + sigma t}
///
/// The last part is the steady profile, which moves with the front.
struct FrontMode {
    std::complex<double> growth;       ///< S = sigma alpha/r^2
    std::complex<double> depth_decay;  ///< lambda; its real part is above zero
    std::complex<double> own_heat;     ///< b = -(1 + Theta S)/lambda

    /// (T at eta [m] - steady T)/(height of the front) [K/m], which holds for small heights.
    std::complex<double> temperature(const SteadyFront& front, double eta) const;
};

/// All modes of wave number K = k alpha/r that fade downwards, the one that grows fastest (or dies
/// slowest) first. Linearised conduction and convection give lambda^2 - lambda = S + K^2; pyrolysis
/// and the flux at the surface (lambda - 1) z + lambda S = z Theta S. Together a cubic for lambda,
///
///     (lambda^2 - lambda - K^2) (lambda - z Theta) + z (lambda - 1) = 0.
std::vector<FrontMode> front_modes(const SteadyFront& front, double wave_number);

}  // namespace crawford::reference
