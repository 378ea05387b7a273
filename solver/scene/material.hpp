/// The thermal, mechanical and burning properties of one propellant constituent.
#pragma once

#include <string>

namespace crawford {

struct Material {
    std::string name;
    double thermal_conductivity;    ///< kappa [W/(m K)]
    double specific_heat;           ///< c_p [J/(kg K)]
    double density;                 ///< rho [kg/m^3]
    double bulk_modulus;            ///< K [Pa]
    double shear_modulus;           ///< mu [Pa]
    double thermal_expansion;       ///< alpha [1/K], linear
    double pyrolysis_prefactor;     ///< A of r_b = A exp(-Ea/(R T_s)) [m/s]
    double activation_temperature;  ///< Ea/R [K]
    double heat_of_reaction;        ///< q_s [J/kg], negative where pyrolysis absorbs heat

    /// Lamé's first parameter lambda = K - 2 mu/3 [Pa] (paper eq. 1).
    double lame() const { return bulk_modulus - 2.0 / 3.0 * shear_modulus; }
};

/// Ammonium perchlorate, as in Table 1 of the paper; material.cpp says where each number comes
/// from.
Material ammonium_perchlorate();

/// HTPB binder, as in Table 1 of the paper; material.cpp says where each number comes from.
Material htpb_binder();

}  // namespace crawford
