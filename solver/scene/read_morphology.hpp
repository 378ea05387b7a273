/// Where which material is, from the table [morphology].
#pragma once

#include <filesystem>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/toml_table.hpp"

namespace crawford {

/// Reads [morphology]: kind = "uniform" {material}, "sandwich" {strip, inner, outer}, or "discs"
/// {file, or discs = [{x, y, radius}, ...] and source; period, particle, matrix}. Files are
/// relative to `directory`; the period of discs is `depth` [m] unless given. Throws InputError.
Morphology read_morphology(TomlTable& scene, const std::vector<Material>& materials, double depth,
                           const std::filesystem::path& directory);

}  // namespace crawford
