/// Sources that drive the solver to a manufactured solution; none in a physical scene.
#pragma once

#include "solver/heat/heat_sources.hpp"
#include "solver/projection/projection_sources.hpp"
#include "solver/stress/stress_sources.hpp"

namespace crawford {

/// The sources of all equations: heat, heat_flux, stress, body_force, traction.
struct Sources : HeatSources, StressSources, ProjectionSources {};

}  // namespace crawford
