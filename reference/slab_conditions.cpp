#include "reference/slab_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {
namespace {

void require_valid(const Material& material) {
    require_positive("thermal_conductivity", material.thermal_conductivity);
    require_positive("specific_heat", material.specific_heat);
    require_positive("density", material.density);
    require_positive("bulk_modulus", material.bulk_modulus);
    require_positive("shear_modulus", material.shear_modulus);
    require_not_negative("thermal_expansion", material.thermal_expansion);
    require_finite("heat_of_reaction", material.heat_of_reaction);
}

}  // namespace

void require_valid(const SlabConditions& conditions) {
    require_valid(conditions.material);
    require_positive("heat_flux", conditions.heat_flux);
    require_finite("pressure", conditions.pressure);
    require_positive("cold_temperature", conditions.cold_temperature);
    if (!std::isinf(conditions.depth)) require_positive("depth", conditions.depth);
    if (conditions.depth < 0.0) throw std::invalid_argument("depth must be positive");
    if (conditions.regression == Regression::prescribed) {
        require_positive("burn_rate", conditions.burn_rate);
    } else {
        require_positive("pyrolysis_prefactor", conditions.material.pyrolysis_prefactor);
        require_positive("activation_temperature", conditions.material.activation_temperature);
    }
    // A surface colder than the solid would need another branch of every formula, and burns
    // nothing.
    const double entering =
        conditions.heat_flux + conditions.material.heat_of_reaction * conditions.material.density *
                                   burn_rate_at(conditions, conditions.cold_temperature);
    if (entering <= 0.0) {
        throw std::invalid_argument("heat_flux is too small: the heat of reaction takes all of it");
    }
}

double thermal_stress_modulus(const SlabConditions& conditions) {
    if (conditions.model == SlabModel::thermal) return 0.0;
    const double factor = conditions.thermal_stress == ThermalStress::three_alpha_k ? 3.0 : 1.0;
    return factor * conditions.material.thermal_expansion * conditions.material.bulk_modulus;
}

double counted_stress_work(const SlabConditions& conditions) {
    if (conditions.heat_capacity == HeatCapacity::constant_pressure) return 1.0;
    const Material& material = conditions.material;
    return -4.0 * material.shear_modulus / (3.0 * material.bulk_modulus);
}

double burn_rate_at(const SlabConditions& conditions, double surface_temperature) {
    if (conditions.regression == Regression::prescribed) return conditions.burn_rate;
    return conditions.material.pyrolysis_prefactor *
           std::exp(-conditions.material.activation_temperature / surface_temperature);
}

double height_within(const SlabConditions& conditions, double y) {
    constexpr double slack = 1e-12;
    if (!(y <= 0.0 && y >= -conditions.depth * (1.0 + slack))) {
        throw std::invalid_argument("y must lie between -depth and the surface at 0");
    }
    return std::max(y, -conditions.depth);
}

}  // namespace crawford::reference
