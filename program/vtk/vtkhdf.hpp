/// VTKHDF: VTK's HDF5 files of unstructured grids.
#pragma once

#include <filesystem>

#include "program/vtk/mesh.hpp"

namespace crawford::vtk {

/// All parts of one time. The attribute `units` of a field is its unit.
/// \throws InputError if it is no such file or is broken
Mesh read_vtkhdf(const std::filesystem::path& path);

}  // namespace crawford::vtk
