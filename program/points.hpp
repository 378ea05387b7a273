/// `crawford points`: fields of a VTU or VTKHDF file as a table.
#pragma once

#include <filesystem>
#include <string>

namespace crawford {

struct PointsOptions {
    std::filesystem::path file;
    std::string at = "points";  ///< or "cells"
    std::filesystem::path out;  ///< stdout if empty
};

/// Whether its first bytes are those of XML or HDF5.
/// \throws InputError if there is no such file
bool is_mesh_file(const std::filesystem::path& file);

/// Prints x, y, the fields and the area of each point or cell as CSV.
/// \throws InputError if the file is no VTU or VTKHDF file of an unstructured plane grid, or is broken
int points(const PointsOptions& options);

}  // namespace crawford
