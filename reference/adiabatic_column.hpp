/// A confined column that is heated as a whole: stress and temperature in closed form.
#pragma once

#include "reference/material.hpp"

namespace crawford::reference {

/// A thermoelastic solid that cannot widen: sigma_22 does as it is told, and no heat is conducted.
struct ConfinedSolid {
    double capacity = missing;  ///< rho c_p [J/(m^3 K)]
    /// beta^2/K [J/(m^3 K^2)], by which the capacity falls with T where it is taken at constant
    /// volume; zero at constant pressure.
    double capacity_slope = 0.0;
    double stress_work = missing;       ///< beta_w of -beta_w T div v [Pa/K]
    double thermal_stress = missing;    ///< beta_s of -beta_s DT/Dt [Pa/K]
    double lame = missing;              ///< lambda [Pa]
    double shear_modulus = missing;     ///< mu [Pa]
    double cold_temperature = missing;  ///< T0 [K], where it is free of stress
};

/// Heated or pressed uniformly it stays uniform, and with e = div v, P = lambda + 2 mu, s the
/// capacity slope,
///
///     (rho c_p - s T) dT/dt = -beta_w T e + q,   dsigma_22/dt = P e - beta_s dT/dt,
///     dsigma_11/dt = lambda e - beta_s dT/dt,
///
/// from which e is eliminated and the rest integrated once.
class AdiabaticColumn {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit AdiabaticColumn(const ConfinedSolid& solid);

    /// T [K] after q has brought `heat` [J/m^3], free to rise (sigma_22 = 0):
    /// rho c_p (T - T0) + (beta_w beta_s/P - s)(T^2 - T0^2)/2 = heat.
    double heated(double heat) const;

    /// T [K] under a pressure [Pa], without q:
    /// (P rho c_p/beta_w) ln(T/T0) + (beta_s - s P/beta_w)(T - T0) = pressure.
    double pressed(double pressure) const;

    /// sigma_11 = sigma_33 [Pa] at that temperature and pressure.
    double lateral_stress(double temperature, double pressure) const;

private:
    double uniaxial_modulus() const { return solid_.lame + 2.0 * solid_.shear_modulus; }

    ConfinedSolid solid_;
};

}  // namespace crawford::reference
