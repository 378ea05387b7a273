/// VTU: VTK's XML files of unstructured grids.
#pragma once

#include <string>

#include "program/vtk/mesh.hpp"

namespace crawford::vtk {

/// All pieces of a VTU file, one after the other: ascii, binary and appended data, raw or in base64,
/// as it is or packed by zlib. A unit is what stands in brackets after an array's name.
/// \param text all of the file
/// \throws InputError if it is no VTU file, is broken, or is packed otherwise
Mesh read_vtu(const std::string& text);

}  // namespace crawford::vtk
