/// A scene as text, for manifests and checkpoints.
#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace crawford {

/// The whole scene, defaults and discs included, as a scene file in SI units. Equal scenes have
/// equal texts, and parse_scene gives back every number to the last bit.
std::string to_toml(const Scene& scene);

}  // namespace crawford
