/// Whatever a file of results is, as tables.
#pragma once

#include <filesystem>
#include <vector>

#include "base/csv_table.hpp"

namespace crawford {

/// A CSV file's table; of a VTU or VTKHDF file (told by its first bytes) the points and the cells, with
/// their areas, as `crawford points` prints them. A mesh is read by a child process: one that breaks the
/// reader does not break this program.
/// \throws InputError naming the file
std::vector<CsvTable> read_tables(const std::filesystem::path& file);

}  // namespace crawford
