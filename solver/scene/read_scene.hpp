/// From a scene file to a Scene.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

/// Reads the scene file `path` (TOML), with the `overrides`, "dotted.key=value", put in place.
///
/// Required are domain.width, depth, nx, ny, morphology.kind with what belongs to it, time.step and
/// time.end, the pressure where there are mechanics, the fluxes where there is heat, and the burn
/// rate where it is fixed; all else has the defaults of scene.hpp. reference_map follows mechanics
/// and stress_work follows thermal_stress unless given; what then still depends on other keys is
/// put in (defaults.hpp), so that the scene says what will be used.
/// \throws InputError, one line: what does not exist, is not TOML, is unknown, missing, of a wrong
/// type or dimension, outside its limits, or at odds with another key (check_scene.hpp).
Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same for a scene in memory; files it names are relative to `directory`.
Scene parse_scene(std::string_view text, const std::filesystem::path& directory = ".",
                  const std::vector<std::string>& overrides = {});

}  // namespace crawford
