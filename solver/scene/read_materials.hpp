/// The materials of a scene: AP and binder, overridden where the scene says so, and its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/scene/material.hpp"
#include "solver/scene/toml_table.hpp"

namespace crawford {

/// AP and binder with the overrides of [materials.AP] and [materials.binder], then every other
/// [materials.NAME], which must give all properties. Throws InputError.
std::vector<Material> read_materials(TomlTable& scene);

/// The names of `materials`, in their order.
std::vector<std::string> names_of(const std::vector<Material>& materials);

/// The material that `table` names at `key`, or `otherwise`; none where the key is required and
/// absent, which the table's finish() will say. Throws InputError where no material has this name.
std::optional<Material> find_material(TomlTable& table, std::string_view key,
                                      const std::vector<Material>& materials,
                                      const std::optional<std::string>& otherwise);

}  // namespace crawford
