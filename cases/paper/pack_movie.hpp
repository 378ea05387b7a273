/// The burning pack of figure 13 as a movie.
#pragma once

#include <vector>

#include "cases/registry.hpp"

namespace crawford {

/// The burn that the movie shows: that of figure 13, its state kept every millisecond.
Scene filmed_pack(Fidelity fidelity);

/// Temperature and strain norm in the laboratory, a frame each millisecond: <figure>.gif. Its
/// numbers are the checkpoints of the burn.
Outcome pack_movie(const Request& request);

}  // namespace crawford
