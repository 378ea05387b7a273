/// Heat that a manufactured solution needs beside what the model gives.
#pragma once

#include "solver/mesh/space_time_function.hpp"

namespace crawford {

struct HeatSources {
    SpaceTimeFunction<double> heat = {};       ///< q [W/m^3]
    SpaceTimeFunction<double> heat_flux = {};  ///< into the solid, beside the burning law's [W/m^2]
};

}  // namespace crawford
