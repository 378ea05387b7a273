/// The coupling number against its limit for the scheme and the readings chosen.
#pragma once

#include "solver/guards/guard.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// Of a material at a temperature [K].
Guard coupling_guard(const Scene& scene, const Material& material, double temperature);

/// rho c_v of a material at a temperature [J/(m^3 K)]: not above zero, only the split is left.
Guard heat_capacity_guard(const Scene& scene, const Material& material, double temperature);

/// T beta_w beta_s/(P rho c), how much more heat a confined solid takes as it expands: from some 3 on
/// bdf2 with mean dilatation does not hold a slab.
Guard expansion_guard(const Scene& scene, const Material& material, double temperature);

}  // namespace crawford
