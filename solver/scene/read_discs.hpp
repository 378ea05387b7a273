/// Discs from a table of centres and radii.
#pragma once

#include <filesystem>
#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

/// Reads a CSV with the header row "x [UNIT],y [UNIT],radius [UNIT]" (the columns in any order, any
/// unit of length) and one disc a row; empty rows and rows that begin with # are passed over.
/// \throws InputError naming the file and the row.
std::vector<Disc> read_discs(const std::filesystem::path& file);

}  // namespace crawford
