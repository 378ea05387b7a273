/// The points or the cells of a plane mesh as a table.
#pragma once

#include <string>

#include "program/vtk/mesh.hpp"

namespace crawford::vtk {

/// CSV: x and y [m], a column for each component of each field at points, and last "area [m2]", what a
/// point stands for: its share of the cells about it. Points without a cell are left out.
/// \throws InputError if the mesh does not lie in a plane of even z or has other than plane cells
std::string table_of_points(const Mesh& mesh);

/// The same of cells: where their corners' mean is, fields at cells, area. Lines and vertices among them are
/// left out.
/// \throws InputError likewise
std::string table_of_cells(const Mesh& mesh);

}  // namespace crawford::vtk
