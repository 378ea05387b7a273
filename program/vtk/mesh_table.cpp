#include "program/vtk/mesh_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/csv_table.hpp"
#include "base/errors.hpp"

namespace crawford::vtk {

namespace {

/// How many corners a cell has, which stand first among its nodes; none: it has no area.
std::optional<std::size_t> corners(const Cell& cell) {
    enum { vertex = 1, vertices, line, lines, triangle, polygon = 7, pixel, quad };
    enum { curved_line = 21, curved_triangle = 22, curved_quad = 23, biquadratic_quad = 28 };
    switch (cell.type) {
        case vertex:
        case vertices:
        case line:
        case lines:
        case curved_line:
            return {};
        case triangle:
        case curved_triangle:
            return 3;
        case polygon:
            return cell.nodes.size();
        case pixel:
        case quad:
        case curved_quad:
        case biquadratic_quad:
            return 4;
        default:
            throw InputError(fmt::format(
                "a cell is of VTK's type {}; triangles, quadrilaterals and polygons are read",
                cell.type));
    }
}

/// Corners in turn, and area and place.
struct Plane {
    std::vector<std::size_t> corners;
    double area = 0.0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
};

Eigen::Vector2d plane(const Eigen::Vector3d& point) {
    return point.head<2>();
}

Plane plane_of(const Mesh& mesh, const Cell& cell, std::size_t count) {
    constexpr int pixel = 8;
    Plane plane_cell;
    for (std::size_t k = 0; k < count; ++k)
        plane_cell.corners.push_back(std::size_t(cell.nodes[k]));
    if (cell.type == pixel) std::swap(plane_cell.corners[2], plane_cell.corners[3]);
    const auto& corners = plane_cell.corners;
    for (std::size_t k = 0; k < count; ++k) {
        const Eigen::Vector2d a = plane(mesh.points[corners[k]]);
        const Eigen::Vector2d b = plane(mesh.points[corners[(k + 1) % count]]);
        plane_cell.area += 0.5 * (a.x() * b.y() - b.x() * a.y());
        plane_cell.centre += a / double(count);
    }
    plane_cell.area = std::abs(plane_cell.area);
    return plane_cell;
}

void check(const Mesh& mesh) {
    for (const Eigen::Vector3d& point : mesh.points) {
        if (!point.allFinite()) throw InputError("a point is no finite number");
        if (point.z() != mesh.points.front().z())
            throw InputError("the points do not lie in one plane z; the cases are plane");
    }
    const auto count = std::int64_t(mesh.points.size());
    for (const Cell& cell : mesh.cells) {
        if (corners(cell).value_or(0) > cell.nodes.size())
            throw InputError(
                fmt::format("a cell of VTK's type {} has {} nodes", cell.type, cell.nodes.size()));
        if (std::ranges::any_of(cell.nodes, [&](auto n) { return n < 0 || n >= count; }))
            throw InputError("a cell has a node that there is not");
    }
}

/// VTK's order of symmetric tensors and of whole ones.
std::string component_name(const Field& field, std::size_t component) {
    static const std::vector<std::string> axes{"x", "y", "z"},
        symmetric{"xx", "yy", "zz", "xy", "yz", "xz"},
        whole{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    if (field.components == 1) return field.name;
    for (const auto* names : {&axes, &symmetric, &whole})
        if (names->size() == field.components || (names == &axes && field.components == 2))
            return field.name + '_' + (*names)[component];
    return fmt::format("{}_{}", field.name, component);
}

std::string header(const std::vector<Field>& fields) {
    std::string text = "x [m],y [m]";
    for (const Field& field : fields)
        for (std::size_t k = 0; k < field.components; ++k) {
            const std::string unit = field.unit.empty() ? "" : fmt::format(" [{}]", field.unit);
            text += ',' + csv_cell(component_name(field, k) + unit);
        }
    return text + ",area [m2]\n";
}

void add_row(std::string& text, const Eigen::Vector2d& place, const std::vector<Field>& fields,
             std::size_t entity, double area) {
    text += fmt::format("{},{}", place.x(), place.y());
    for (const Field& field : fields)
        for (std::size_t k = 0; k < field.components; ++k)
            text += fmt::format(",{}", field.values[entity * field.components + k]);
    text += fmt::format(",{}\n", area);
}

void check_sizes(const std::vector<Field>& fields, std::size_t count, const char* of) {
    // Each is a column of the table, also where there are no rows: a broken file asks for any number.
    constexpr std::size_t most = 1000;
    for (const Field& field : fields) {
        if (field.components > most)
            throw InputError(fmt::format("{} has {} components; at most {} are read", field.name,
                                         field.components, most));
        if (field.components == 0 || field.values.size() != count * field.components)
            throw InputError(fmt::format("{} has {} numbers for {} {}", field.name,
                                         field.values.size(), count, of));
    }
}

}  // namespace

std::string table_of_points(const Mesh& mesh) {
    check(mesh);
    check_sizes(mesh.at_points, mesh.points.size(), "points");
    std::vector<double> area(mesh.points.size(), 0.0);
    for (const Cell& cell : mesh.cells)
        if (const auto count = corners(cell)) {
            const Plane one = plane_of(mesh, cell, *count);
            for (const std::size_t corner : one.corners) area[corner] += one.area / double(*count);
        }
    std::string text = header(mesh.at_points);
    for (std::size_t k = 0; k < mesh.points.size(); ++k)
        if (area[k] > 0.0) add_row(text, plane(mesh.points[k]), mesh.at_points, k, area[k]);
    return text;
}

std::string table_of_cells(const Mesh& mesh) {
    check(mesh);
    check_sizes(mesh.at_cells, mesh.cells.size(), "cells");
    std::string text = header(mesh.at_cells);
    for (std::size_t k = 0; k < mesh.cells.size(); ++k)
        if (const auto count = corners(mesh.cells[k])) {
            const Plane one = plane_of(mesh, mesh.cells[k], *count);
            if (one.area > 0.0) add_row(text, one.centre, mesh.at_cells, k, one.area);
        }
    return text;
}

}  // namespace crawford::vtk
