/// Movies of cases, drawn as cases of their own.
#pragma once

#include <string>
#include <vector>

#include "cases/registry.hpp"

namespace crawford {

/// What a movie is drawn and recorded as: "fig13_movie".
std::string movie_name(const Entry& entry);

/// The movies of these cases, ready to be drawn like any other case; of all cases that have one if
/// no name is given.
/// \throws InputError as choose_cases, and if a case has no movie
std::vector<Entry> choose_movies(const std::vector<std::string>& names);

}  // namespace crawford
