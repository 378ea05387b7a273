/// Where which material is, from the table [morphology].
#pragma once

#include <filesystem>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/toml_table.hpp"

namespace crawford {

/// Reads [morphology]: kind = "uniform" {material}, "sandwich" {strip, inner, outer}, "discs"
/// {file, or discs = [{x, y, radius}, ...] and source; period, particle, matrix}, or "pack"
/// {particle, matrix, and what read_pack.hpp reads}, which becomes the discs of a random pack.
/// Files are relative to `directory`; the period of discs is the domain's depth unless given.
/// Throws InputError.
Morphology read_morphology(TomlTable& scene, const std::vector<Material>& materials,
                           const Domain& domain, const std::filesystem::path& directory);

}  // namespace crawford
