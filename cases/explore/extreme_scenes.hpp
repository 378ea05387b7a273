/// What the extremes are taken from: the paper's materials and fluxes.
#pragma once

#include <vector>

#include "cases/units.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// The paper's, into AP [W/m^2].
inline constexpr double flux_into_ap = 200.0 * units::cal / (units::s * units::cm2);

/// AP and binder.
const std::vector<Material>& propellant();

/// One column without mechanics, 480 um deep in 96 rows, for 40 ms.
/// \param flux over the paper's into AP
Scene burning_slab(const Material& material, double flux);

/// Half a sandwich without mechanics, a strip of 60 um in 240 um, 48 rows, for 20 ms.
/// \param flux over the paper's
Scene half_sandwich(int columns, double flux);

}  // namespace crawford
