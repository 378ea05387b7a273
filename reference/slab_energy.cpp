#include "reference/slab_energy.hpp"

#include <cmath>
#include <limits>

namespace crawford::reference {

SlabEnergy::SlabEnergy(const SlabConditions& conditions)
    : model_(conditions.model),
      rho_c_(conditions.material.density * conditions.material.specific_heat),
      beta_(thermal_stress_modulus(conditions)),
      theta_(beta_ / conditions.material.uniaxial_modulus()),
      counted_work_(counted_stress_work(conditions)),
      cold_(conditions.cold_temperature) {}

double SlabEnergy::largest_rise() const {
    const double slope = -counted_work_ * beta_ * theta_;  // by which g'/exp(theta D) falls with T
    return slope > 0.0 ? rho_c_ / slope - cold_ : std::numeric_limits<double>::infinity();
}

double SlabEnergy::heat_content(double rise) const {
    // A material that does not expand is thermal under every model, and expm1(0)/0 has no value.
    if (theta_ == 0.0) return rho_c_ * rise;
    if (model_ == SlabModel::kuznetsov_stewart) {
        return rho_c_ * rise + counted_work_ * beta_ * theta_ * rise * (cold_ + rise / 2.0);
    }
    const double stretch = std::expm1(theta_ * rise) / theta_;  // integral of exp(theta D), [K]
    const double stress_work =
        beta_ * (theta_ * cold_ - 1.0) * stretch + beta_ * rise * std::exp(theta_ * rise);
    const double stored = model_ == SlabModel::eulerian ? rho_c_ * stretch : rho_c_ * rise;
    return stored + counted_work_ * stress_work;
}

}  // namespace crawford::reference
