/// The burning pack of figure 13 as a movie.
#pragma once

#include "cases/registry.hpp"

namespace crawford {

/// Temperature and strain norm in the laboratory, a frame each millisecond: <figure>.gif. Its
/// numbers are the checkpoints of figure 13's burn.
Outcome pack_movie(const Request& request);

}  // namespace crawford
