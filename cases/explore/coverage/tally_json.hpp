/// All numbers of the coverage, for other programs.
#pragma once

#include <string>
#include <vector>

#include "cases/explore/coverage/tally.hpp"

namespace crawford {

/// { wanted, default, chosen, estimates: [ ... ], quantities: [ ... ] }; what is not there is null.
std::string json_of(const std::vector<reports::KnownSeries>& all,
                    const std::vector<TalliedEstimate>& tallied);

}  // namespace crawford
