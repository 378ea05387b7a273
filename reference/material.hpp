/// Material constants of the truths, typed in apart from those of the solver.
#pragma once

#include <limits>

namespace crawford::reference {

/// Value of a parameter nobody has given; every truth refuses it by name.
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Properties of one constituent, SI. Typed in from the source here, and not shared with the
/// solver: a slip in either table then shows as a disagreement.
struct Material {
    double thermal_conductivity = missing;    ///< kappa [W/(m K)]
    double specific_heat = missing;           ///< c_p [J/(kg K)]
    double density = missing;                 ///< rho [kg/m^3]
    double bulk_modulus = missing;            ///< K [Pa]
    double shear_modulus = missing;           ///< mu [Pa]
    double thermal_expansion = missing;       ///< alpha, linear [1/K]
    double pyrolysis_prefactor = missing;     ///< A [m/s]
    double activation_temperature = missing;  ///< Ea/R [K]
    double heat_of_reaction = missing;        ///< q_s [J/kg], negative where pyrolysis absorbs heat

    /// First Lame parameter lambda = K - 2 mu/3 [Pa].
    double lame() const { return bulk_modulus - 2.0 * shear_modulus / 3.0; }
    /// Stiffness under uniaxial strain, P = lambda + 2 mu [Pa].
    double uniaxial_modulus() const { return lame() + 2.0 * shear_modulus; }
};

/// Thermochemical calorie [J], the one combustion tables are written in.
inline constexpr double calorie = 4.184;
/// A flux of one cal/(s cm^2) [W/m^2].
inline constexpr double calorie_per_second_per_cm2 = calorie * 1e4;

namespace detail {
/// 0.3 kcal/(kg K), the gas value that the paper takes for the solid too.
inline constexpr double gas_specific_heat = 0.3 * 1000.0 * calorie;
inline constexpr double kilocalorie_per_kilogram = 1000.0 * calorie;
}  // namespace detail

/// Ammonium perchlorate, paper Table 1, with A read in m/s and q_s in kcal/kg (the printed cm/s and
/// J/kg do not give the burn rates the paper reports).
inline Material ap() {
    return {.thermal_conductivity = 0.405,
            .specific_heat = detail::gas_specific_heat,
            .density = 1950.0,
            .bulk_modulus = 14950e6,
            .shear_modulus = 12500e6,
            .thermal_expansion = 1e-5,
            .pyrolysis_prefactor = 1450.0,
            .activation_temperature = 11000.0,
            .heat_of_reaction = -47.0 * detail::kilocalorie_per_kilogram};
}

/// HTPB binder, paper Table 1, read as `ap()` is.
inline Material binder() {
    return {.thermal_conductivity = 0.276,
            .specific_heat = detail::gas_specific_heat,
            .density = 920.0,
            .bulk_modulus = 10670e6,
            .shear_modulus = 2.5e6,
            .thermal_expansion = 1e-4,
            .pyrolysis_prefactor = 10.36,
            .activation_temperature = 7500.0,
            .heat_of_reaction = -100.0 * detail::kilocalorie_per_kilogram};
}

/// The same material whose pyrolysis neither absorbs nor frees heat, as the paper's one-dimensional
/// study has it.
inline Material without_reaction(Material material) {
    material.heat_of_reaction = 0.0;
    return material;
}

}  // namespace crawford::reference
