#include "program/vtk/vtkhdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"

namespace crawford::vtk {

namespace {

std::vector<Field> fields(const Hdf5File& file, const std::string& group) {
    std::vector<Field> all;
    if (!file.contains(group)) return all;
    for (const std::string& name : file.names(group)) {
        const std::string path = fmt::format("{}/{}", group, name);
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

/// What a part of the file says of itself, and where it begins.
struct Part {
    std::int64_t points, cells, ids;
    std::size_t first_point = 0, first_id = 0, first_offset = 0, first_type = 0;
};

/// Sizes as a broken file may give them: any.
std::size_t within(std::int64_t size, std::size_t room) {
    if (size < 0 || std::uint64_t(size) > room)
        throw InputError("its parts hold more than it has in all");
    return std::size_t(size);
}

class Cells {
public:
    explicit Cells(const Hdf5File& file)
        : nodes_(sizes(file, "Connectivity")),
          ends_(sizes(file, "Offsets")),
          types_(sizes(file, "Types")) {}

    /// Connectivity and offsets begin anew in each part.
    void add(Mesh& mesh, Part& part) const {
        const std::size_t points = within(part.points, mesh.points.size() - part.first_point),
                          cells = within(part.cells, types_.size() - part.first_type),
                          ids = within(part.ids, nodes_.size() - part.first_id);
        // One more offset than cells.
        within(part.cells, ends_.size() - std::min(ends_.size(), part.first_offset + 1));
        for (std::size_t k = 0; k < cells; ++k) {
            const auto from = ends_[part.first_offset + k], to = ends_[part.first_offset + k + 1];
            if (from < 0 || to < from || std::uint64_t(to) > ids)
                throw InputError("the offsets of its cells do not rise within their nodes");
            Cell cell{.type = int(types_[part.first_type + k]), .nodes = {}};
            for (auto n = from; n < to; ++n) {
                const auto node = nodes_[part.first_id + std::size_t(n)];
                if (node < 0 || std::uint64_t(node) >= points)
                    throw InputError("a cell has a node that there is not");
                cell.nodes.push_back(std::int64_t(part.first_point) + node);
            }
            mesh.cells.push_back(std::move(cell));
        }
        part.first_point += points;
        part.first_id += ids;
        part.first_type += cells;
        part.first_offset += cells + 1;
    }

private:
    std::vector<std::int64_t> nodes_, ends_, types_;
};

void add_cells(Mesh& mesh, const Hdf5File& file) {
    const auto points = sizes(file, "NumberOfPoints"), cells = sizes(file, "NumberOfCells"),
               ids = sizes(file, "NumberOfConnectivityIds");
    if (points.size() != cells.size() || ids.size() != cells.size())
        throw InputError("its parts are not as many in all that it says of them");
    const Cells all(file);
    Part part{};
    for (std::size_t k = 0; k < cells.size(); ++k) {
        part.points = points[k];
        part.cells = cells[k];
        part.ids = ids[k];
        all.add(mesh, part);
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
