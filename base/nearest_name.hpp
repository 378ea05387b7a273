/// The right name behind a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crawford {

/// The name of `names` with the fewest letters inserted, deleted, changed or swapped to `misspelt`,
/// upper and lower case being alike; empty where none is near, that is within a third of the
/// letters (at least one, two for four and more).
std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& names);

/// "; did you mean NAME?", or "; known: a, b, c" where none is near.
std::string suggestion(std::string_view misspelt, const std::vector<std::string>& names);

}  // namespace crawford
