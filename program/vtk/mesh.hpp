/// A mesh with fields, as VTK's files hold it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace crawford::vtk {

struct Cell {
    int type;  ///< VTK's number: 5 is a triangle, 9 a quadrilateral
    std::vector<std::int64_t> nodes;
};

/// A field at points or cells: `components` numbers each.
struct Field {
    std::string name;
    std::string unit;  ///< empty where the file does not say
    std::size_t components = 1;
    std::vector<double> values;
};

struct Mesh {
    std::vector<Eigen::Vector3d> points;
    std::vector<Cell> cells;
    std::vector<Field> at_points, at_cells;
};

}  // namespace crawford::vtk
