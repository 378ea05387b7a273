/// The maps of the extremes.
#pragma once

#include <vector>

#include "cases/explore/extreme_map.hpp"

namespace crawford {

std::vector<ExtremeMap> maps_of_slabs();
std::vector<ExtremeMap> maps_of_sandwiches();

}  // namespace crawford
