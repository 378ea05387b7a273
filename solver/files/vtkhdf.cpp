#include "solver/files/vtkhdf.hpp"

#include <array>
#include <string>
#include <vector>

#include "solver/files/hdf5_file.hpp"

namespace crawford {

namespace {

constexpr std::uint8_t vtk_quad = 9;
constexpr int corners = 4;

using Numbers = std::span<const double>;
using Integers = std::span<const std::int64_t>;

struct Mesh {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets = {0};
};

/// Nodes and cells are counted as lattices store them: up a column, then on to the next.
Mesh quadrilaterals(int node_columns, int node_rows) {
    Mesh mesh;
    for (std::int64_t i = 0; i + 1 < node_columns; ++i)
        for (std::int64_t j = 0; j + 1 < node_rows; ++j) {
            const std::int64_t left = i * node_rows + j;
            const std::int64_t right = left + node_rows;
            mesh.connectivity.insert(mesh.connectivity.end(), {left, right, right + 1, left + 1});
            mesh.offsets.push_back(mesh.offsets.back() + corners);
        }
    return mesh;
}

void write_count(Hdf5File& file, const std::string& name, size_t count) {
    const auto number = std::int64_t(count);
    file.write("/VTKHDF/" + name, Integers(&number, 1), {1}, "1");
}

template <class Value, class Components>
void write_field(Hdf5File& file, const std::string& name, const Lattice<Value>& field,
                 const std::string& units, Components components) {
    if (field.empty()) return;
    std::vector<double> numbers;
    for (const Value& value : field.values())
        for (const double component : components(value)) numbers.push_back(component);
    const size_t count = field.values().size();
    file.write("/VTKHDF/" + name, Numbers(numbers), {count, numbers.size() / count}, units);
}

void write_field(Hdf5File& file, const std::string& name, const Lattice<double>& field,
                 const std::string& units) {
    if (field.empty()) return;
    file.write("/VTKHDF/" + name, Numbers(field.values()), {field.values().size()}, units);
}

std::array<double, 3> in_space(const Vector& v) {
    return {v.x(), v.y(), 0.0};
}

void write_mesh(Hdf5File& file, const NodeVectors& position) {
    file.create_group("/VTKHDF");
    file.set_attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
    file.set_fixed_attribute("/VTKHDF", "Type", "UnstructuredGrid");
    const Mesh mesh = quadrilaterals(position.columns(), position.rows());
    const size_t cells = mesh.offsets.size() - 1;
    write_count(file, "NumberOfPoints", position.values().size());
    write_count(file, "NumberOfCells", cells);
    write_count(file, "NumberOfConnectivityIds", mesh.connectivity.size());
    write_field(file, "Points", position, "m", in_space);
    file.write("/VTKHDF/Connectivity", Integers(mesh.connectivity), {mesh.connectivity.size()},
               "1");
    file.write("/VTKHDF/Offsets", Integers(mesh.offsets), {mesh.offsets.size()}, "1");
    const std::vector<std::uint8_t> types(cells, vtk_quad);
    file.write("/VTKHDF/Types", std::span<const std::uint8_t>(types), {cells}, "1");
}

void write_fields(Hdf5File& file, const Snapshot& snapshot) {
    file.create_group("/VTKHDF/PointData");
    write_field(file, "PointData/material_indicator", snapshot.material_indicator, "1");
    write_field(file, "PointData/temperature", snapshot.temperature, "K");
    write_field(file, "PointData/velocity", snapshot.velocity, "m/s", in_space);
    write_field(file, "PointData/reference_map", snapshot.reference_map, "m", in_space);
    file.create_group("/VTKHDF/CellData");
    write_field(file, "CellData/material", snapshot.material, "1");
    write_field(file, "CellData/stress", snapshot.stress, "Pa", [](const PlaneStress& s) {
        return std::array{s.s11, s.s22, s.s33, s.s12, 0.0, 0.0};
    });
    write_field(file, "CellData/pressure", snapshot.pressure, "Pa");
    write_field(file, "CellData/strain", snapshot.strain, "1", [](const std::array<double, 3>& e) {
        return std::array{e[0], e[1], 0.0, e[2], 0.0, 0.0};
    });
    write_field(file, "CellData/strain_norm", snapshot.strain_norm, "1");
}

void write_origin(Hdf5File& file, const Snapshot& snapshot, const Provenance& provenance) {
    const std::int64_t step = snapshot.step;
    file.create_group("/crawford");
    file.write("/crawford/time", Numbers(&snapshot.time, 1), {}, "s");
    file.write("/crawford/step", Integers(&step, 1), {}, "1");
    file.set_attribute("/crawford", "scene", provenance.scene);
    file.set_attribute("/crawford", "version", provenance.version);
    file.set_attribute("/crawford", "revision", provenance.revision);
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const Snapshot& snapshot,
                  const Provenance& provenance) {
    Hdf5File file = Hdf5File::create(path);
    write_mesh(file, snapshot.position);
    write_fields(file, snapshot);
    write_origin(file, snapshot, provenance);
    file.publish();
}

}  // namespace crawford
