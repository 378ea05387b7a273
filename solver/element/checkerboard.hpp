/// The one pressure pattern that bilinear velocities cannot see, taken out of the element.
///
/// With one pressure a cell, a pressure that alternates in sign like a checkerboard exerts next to
/// no force, so next to nothing determines it: near a singular corner it rings far into an almost
/// incompressible material, and the surface velocity with it. On patches of 2 x 2 cells of one
/// material the pressure therefore keeps three of its four modes (constant, linear along and
/// across): bilinear velocities with a linear pressure on twice the cell, a pair that is stable
/// (Boland & Nicolaides 1985; Stenberg 1984). A pressure that varies along one direction only is
/// untouched.
#pragma once

#include <array>

#include "solver/materials/material_map.hpp"
#include "solver/mesh/cell.hpp"

namespace crawford {

/// 2 x 2 cells, named by the one at the lower left.
struct Patch {
    int i, j;
};

/// The nine nodes of a patch, row by row from the lower left.
std::array<Node, 9> patch_nodes(const Grid& grid, const Patch& patch);

/// Every patch of a grid, paired from the surface down and from the left; what is left over stays
/// in single cells.
std::vector<Patch> all_patches(const Grid& grid);

class Checkerboard {
public:
    Checkerboard(const Grid& grid, const MaterialMap& materials, Element element);

    /// None for the paper's element.
    const std::vector<Patch>& patches() const { return patches_; }

    /// True where all four cells hold the same material and nothing else.
    bool is_one_material(const Patch& patch) const;

    /// Takes the checkerboard, weighted by area, out of a cell field on patches of one material.
    void remove_from(CellField& field) const;

    /// Nodal forces of a unit checkerboard pressure, (node 0 x, node 0 y, ...) [m].
    Eigen::Matrix<double, 18, 1> unit_force(const Patch& patch, const SurfaceField& surface) const;

    double area(const Patch& patch) const;  ///< [m^2]

private:
    const Grid& grid_;
    const MaterialMap& materials_;
    std::vector<Patch> patches_;
};

}  // namespace crawford
