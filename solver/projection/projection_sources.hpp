/// Loads that a manufactured solution needs beside what the model gives.
#pragma once

#include "solver/mesh/lattice.hpp"
#include "solver/mesh/space_time_function.hpp"

namespace crawford {

struct ProjectionSources {
    SpaceTimeFunction<Vector> body_force = {};  ///< b [N/m^3]
    SpaceTimeFunction<Vector> traction = {};    ///< sigma.n beside the gas pressure's [Pa]
};

}  // namespace crawford
