/// The thermal, mechanical and burning properties of one propellant constituent.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/scene/limits.hpp"

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
    /// D = kappa/(rho c_p) [m^2/s].
    double diffusivity() const { return thermal_conductivity / (density * specific_heat); }
    /// P = K + 4 mu/3 [Pa], of what cannot widen.
    double uniaxial_modulus() const { return bulk_modulus + 4.0 / 3.0 * shear_modulus; }
};

/// [m^2/s]; 0 of none.
double largest_diffusivity(const std::vector<Material>& materials);

/// A property as a scene gives it: its key, where it is kept, its unit and limits.
struct MaterialProperty {
    const char* name;
    double Material::*member;
    Limits limits;
};

/// All of them, in the order in which they are written.
inline constexpr std::array material_properties{
    MaterialProperty{
        "thermal_conductivity", &Material::thermal_conductivity, {"W/(m K)", 1e-6, 1e6}},
    MaterialProperty{"specific_heat", &Material::specific_heat, {"J/(kg K)", 1e-3, 1e6}},
    MaterialProperty{"density", &Material::density, {"kg/m3", 1e-3, 1e6}},
    MaterialProperty{"bulk_modulus", &Material::bulk_modulus, {"Pa", 1.0, 1e16}},
    MaterialProperty{"shear_modulus", &Material::shear_modulus, {"Pa", 1.0, 1e16}},
    MaterialProperty{"thermal_expansion", &Material::thermal_expansion, {"1/K", 0.0, 0.1}},
    MaterialProperty{"pyrolysis_prefactor", &Material::pyrolysis_prefactor, {"m/s", 1e-9, 1e12}},
    MaterialProperty{"activation_temperature", &Material::activation_temperature, {"K", 0.0, 1e6}},
    MaterialProperty{"heat_of_reaction", &Material::heat_of_reaction, {"J/kg", -1e8, 1e8}}};

/// Ammonium perchlorate, as in Table 1 of the paper; material.cpp says where each number comes
/// from.
Material ammonium_perchlorate();

/// HTPB binder, as in Table 1 of the paper; material.cpp says where each number comes from.
Material htpb_binder();

}  // namespace crawford
