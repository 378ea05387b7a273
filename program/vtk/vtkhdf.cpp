#include "program/vtk/vtkhdf.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"

namespace crawford::vtk {

namespace {

std::vector<Field> fields(const Hdf5File& file, const std::string& group) {
    std::vector<Field> all;
    if (!file.contains(group)) return all;
    for (const std::string& name : file.names(group)) {
        const std::string path = group + '/' + name;
        const auto shape = file.shape(path);
        Field field{
            .name = name,
            .unit = file.has_attribute(path, "units") ? file.text_attribute(path, "units") : "",
            .components = shape.size() > 1 ? std::size_t(shape[1]) : 1,
            .values = file.read<double>(path)};
        all.push_back(std::move(field));
    }
    return all;
}

/// Sizes of the parts that a file is written in.
std::vector<std::int64_t> sizes(const Hdf5File& file, const std::string& name) {
    return file.read<std::int64_t>("/VTKHDF/" + name);
}

void add_points(Mesh& mesh, const Hdf5File& file) {
    const auto x = file.read<double>("/VTKHDF/Points");
    if (x.size() % 3 != 0) throw InputError("its points do not have three coordinates each");
    for (std::size_t k = 0; k < x.size(); k += 3)
        mesh.points.emplace_back(x[k], x[k + 1], x[k + 2]);
}

/// Connectivity and offsets begin anew in each part.
void add_cells(Mesh& mesh, const Hdf5File& file) {
    const auto nodes = sizes(file, "Connectivity"), ends = sizes(file, "Offsets"),
               types = sizes(file, "Types"), points = sizes(file, "NumberOfPoints"),
               cells = sizes(file, "NumberOfCells"), ids = sizes(file, "NumberOfConnectivityIds");
    std::size_t node = 0, end = 0, type = 0;
    std::int64_t point = 0;
    if (points.size() != cells.size() || ids.size() != cells.size())
        throw InputError("its parts are not as many in all that it says of them");
    for (std::size_t part = 0; part < cells.size(); ++part) {
        for (std::int64_t k = 0; k < cells[part]; ++k, ++end, ++type) {
            if (end + 1 >= ends.size() || type >= types.size())
                throw InputError("it has fewer cells than it says");
            Cell cell{.type = int(types[type]), .nodes = {}};
            for (std::int64_t n = ends[end]; n < ends[end + 1]; ++n) {
                if (n < 0 || node + std::size_t(n) >= nodes.size())
                    throw InputError("the offsets of its cells lie outside their nodes");
                cell.nodes.push_back(point + nodes[node + std::size_t(n)]);
            }
            mesh.cells.push_back(std::move(cell));
        }
        ++end;  // one more offset than cells
        point += points[part];
        node += std::size_t(ids[part]);
    }
}

}  // namespace

Mesh read_vtkhdf(const std::filesystem::path& path) {
    const Hdf5File file = Hdf5File::open(path);
    for (const char* needed : {"/VTKHDF", "/VTKHDF/Points", "/VTKHDF/Connectivity"})
        if (!file.contains(needed))
            throw InputError(
                fmt::format("it has no {}; an unstructured grid of VTKHDF has", needed));
    if (file.contains("/VTKHDF/Steps"))
        throw InputError("it holds a series of times; write one file a time");
    Mesh mesh;
    add_points(mesh, file);
    add_cells(mesh, file);
    mesh.at_points = fields(file, "/VTKHDF/PointData");
    mesh.at_cells = fields(file, "/VTKHDF/CellData");
    return mesh;
}

}  // namespace crawford::vtk
