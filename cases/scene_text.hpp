/// Scenes in the small print of figures.
#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace crawford {

/// "64 × 96, clustering 2"
std::string grid_text(const Scene& scene);
/// "20 µs, t = 0.1 s"
std::string step_text(const Scene& scene);

}  // namespace crawford
