/// Where the time of a run went.
#pragma once

#include <string>
#include <vector>

#include "solver/step/simulation.hpp"

namespace crawford {

/// A table of seconds, share and milliseconds a step for each module; what `seconds`, the whole,
/// leaves over is output and bookkeeping.
std::string timing_table(const std::vector<ModuleTime>& modules, double seconds, long steps);

}  // namespace crawford
