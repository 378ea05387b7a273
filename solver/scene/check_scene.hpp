/// Whether the parts of a scene fit together.
#pragma once

#include "solver/scene/scene.hpp"

namespace crawford {

/// Refuses a scene whose parts are at odds: a strip wider than the domain or thinner than a cell,
/// discs that overlap, half a scene that is not symmetric, a burning law without a temperature, and
/// the like. Scenes from read_scene have been checked.
/// \throws InputError, one line that names the keys, the values and what to do.
void check(const Scene& scene);

}  // namespace crawford
