/// What a scene's numbers will be, from the scene and one slab of each of its materials. Nothing is
/// run.
#pragma once

#include "solver/guards/guard.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// \param scene that has passed check()
Guards predicted(const Scene& scene);

}  // namespace crawford
