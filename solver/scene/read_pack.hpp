/// What a random pack is to be, from a table of the scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "solver/packing/pack.hpp"
#include "solver/scene/toml_table.hpp"

namespace crawford {

/// Reads area_fraction, smallest_gap, seed, and discs: [{radius, count}, ...], or [{radius, share},
/// ...] with count, the number of all. `width` is the domain's [m]. Throws InputError.
PackRecipe read_recipe(TomlTable& table, double width);

/// The recipe in one line, for the record.
std::string description(const PackRecipe&);

/// The seed that a description tells of; none if it is another text, as of discs from a table.
std::optional<std::uint64_t> seed_of(std::string_view description);

}  // namespace crawford
