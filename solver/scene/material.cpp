#include "solver/scene/material.hpp"

#include <algorithm>

namespace crawford {

namespace {

// Provenance: Kumar, Rycroft & Jackson, Combust. Flame 2020, Table 1 (after Srinivasan et al.
// 2009), with three readings. The Arrhenius constants are printed in cm/s: only as m/s do the
// reported surface temperatures give the reported burn rates. The heats of reaction are printed in
// J/kg: read as kcal/kg, absorbed. The specific heat is said to be that of the gas and not printed:
// 0.3 kcal/(kg K), usual in this literature.
constexpr double thermochemical_kilocalorie = 4184.0;  // [J]
constexpr double specific_heat_of_the_gas = 0.3 * thermochemical_kilocalorie;

}  // namespace

Material ammonium_perchlorate() {
    return {.name = "AP",
            .thermal_conductivity = 0.405,
            .specific_heat = specific_heat_of_the_gas,
            .density = 1950.0,
            .bulk_modulus = 14950.0e6,
            .shear_modulus = 12500.0e6,
            .thermal_expansion = 1.0e-5,
            .pyrolysis_prefactor = 1450.0,
            .activation_temperature = 11000.0,
            .heat_of_reaction = -47.0 * thermochemical_kilocalorie};
}

Material htpb_binder() {
    return {.name = "binder",
            .thermal_conductivity = 0.276,
            .specific_heat = specific_heat_of_the_gas,
            .density = 920.0,
            .bulk_modulus = 10670.0e6,
            .shear_modulus = 2.5e6,
            .thermal_expansion = 1.0e-4,
            .pyrolysis_prefactor = 10.36,
            .activation_temperature = 7500.0,
            .heat_of_reaction = -100.0 * thermochemical_kilocalorie};
}

double largest_diffusivity(const std::vector<Material>& materials) {
    double largest = 0.0;
    for (const Material& material : materials) largest = std::max(largest, material.diffusivity());
    return largest;
}

}  // namespace crawford
