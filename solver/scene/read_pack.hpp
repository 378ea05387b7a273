/// What a random pack is to be, from a table of the scene.
#pragma once

#include <string>

#include "solver/packing/pack.hpp"
#include "solver/scene/toml_table.hpp"

namespace crawford {

/// Reads area_fraction, smallest_gap, seed, and discs: [{radius, count}, ...], or [{radius, share},
/// ...] with count, the number of all. `width` is the domain's [m]. Throws InputError.
PackRecipe read_recipe(TomlTable& table, double width);

/// The recipe in one line, for the record.
std::string description(const PackRecipe&);

}  // namespace crawford
