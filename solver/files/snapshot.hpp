/// What a picture of the solid at one time shows, as plain data.
#pragma once

#include <array>

#include "solver/element/stress_field.hpp"
#include "solver/mesh/grid.hpp"
#include "solver/mesh/lattice.hpp"
#include "solver/step/state.hpp"

namespace crawford {

class Simulation;

/// Node fields have cell columns + 1 columns: with periodic sides the first column stands again,
/// one period further, so that the picture is whole. A field that the scene does not have is empty.
struct Snapshot {
    long step = 0;
    double time = 0.0;                      ///< [s]
    NodeVectors position;                   ///< (x, y) of the nodes [m]
    NodeField material_indicator;           ///< 1 in the first material, -1 in the second
    NodeField temperature;                  ///< [K]
    NodeVectors velocity;                   ///< [m/s]
    NodeVectors reference_map;              ///< xi [m]
    CellField material;                     ///< fraction of the first material
    Lattice<PlaneStress> stress;            ///< mean of each cell [Pa]
    CellField pressure;                     ///< [Pa]
    Lattice<std::array<double, 3>> strain;  ///< E11, E22, E12
    CellField strain_norm;                  ///< in the scene's norm
};

/// A node field with the column on the right side: with periodic sides, the first one again.
template <class Value>
Lattice<Value> with_right_side(const Grid& grid, const Lattice<Value>& field) {
    if (field.empty()) return {};
    Lattice<Value> whole(grid.cell_columns() + 1, field.rows(), field(0, 0));
    for (int i = 0; i <= grid.cell_columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) whole(i, j) = field(i % field.columns(), j);
    return whole;
}

/// Where the nodes of a grid below `surface` are, with the column on the right side.
NodeVectors positions(const Grid& grid, const SurfaceField& surface);

/// The part of a snapshot that grid and state know by themselves; materials and strains stay empty.
Snapshot collect_snapshot(const Grid& grid, const State& state);

/// The whole snapshot.
Snapshot collect_snapshot(const Simulation& simulation);

}  // namespace crawford
