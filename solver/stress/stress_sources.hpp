/// Stress that a manufactured solution needs beside what the model gives.
#pragma once

#include "solver/element/stress_field.hpp"
#include "solver/mesh/space_time_function.hpp"

namespace crawford {

struct StressSources {
    SpaceTimeFunction<PlaneStress> stress = {};  ///< S [Pa/s]
};

}  // namespace crawford
