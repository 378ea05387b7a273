/// What a scene's numbers will be, before it is run.
#pragma once

#include "solver/scene/scene.hpp"

namespace crawford {

/// Prints each number with its limit, what it will do, and what the scene could leave out; or all
/// that as JSON. Runs and writes nothing.
/// \returns exit_code::done
/// \throws InputError, once all is printed, if the scene is refused.
int check(const Scene& scene, bool json);

}  // namespace crawford
