#include "reference/slab_energy.hpp"

#include <cmath>

namespace crawford::reference {

SlabEnergy::SlabEnergy(const SlabConditions& conditions)
    : model_(conditions.model),
      rho_c_(conditions.material.density * conditions.material.specific_heat),
      beta_(thermal_stress_modulus(conditions)),
      theta_(beta_ / conditions.material.uniaxial_modulus()),
      cold_(conditions.cold_temperature) {}

double SlabEnergy::heat_content(double rise) const {
    // A material that does not expand is thermal under every model, and expm1(0)/0 has no value.
    if (theta_ == 0.0) return rho_c_ * rise;
    if (model_ == SlabModel::kuznetsov_stewart) {
        return rho_c_ * rise + beta_ * theta_ * rise * (cold_ + rise / 2.0);
    }
    const double stretch = std::expm1(theta_ * rise) / theta_;  // integral of exp(theta D), [K]
    const double stress_work =
        beta_ * (theta_ * cold_ - 1.0) * stretch + beta_ * rise * std::exp(theta_ * rise);
    const double stored = model_ == SlabModel::eulerian ? rho_c_ * stretch : rho_c_ * rise;
    return stored + stress_work;
}

}  // namespace crawford::reference
