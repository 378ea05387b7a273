#include "reference/slab_small_strain.hpp"

#include <cmath>
#include <stdexcept>

#include "reference/slab.hpp"

namespace crawford::reference {

double small_strain_sensitivity(const SlabConditions& conditions) {
    require_valid(conditions);
    if (conditions.regression != Regression::prescribed)
        throw std::invalid_argument("regression must be prescribed");
    if (std::isfinite(conditions.depth)) throw std::invalid_argument("depth must be infinite");

    SlabConditions small = conditions;
    small.model = SlabModel::kuznetsov_stewart;
    const double hot = Slab(small).surface_temperature();
    const double rise = hot - small.cold_temperature;
    const double beta = thermal_stress_modulus(small);
    const double coupling =
        counted_stress_work(small) * beta * beta / small.material.uniaxial_modulus();
    const double heat_capacity = small.material.density * small.material.specific_heat;
    const double carried =
        rise * rise *
        ((heat_capacity + coupling * small.cold_temperature) / 2.0 + coupling * rise / 3.0);
    return -carried / (heat_capacity + coupling * hot);
}

}  // namespace crawford::reference
