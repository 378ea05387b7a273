/// What follows from material fractions and deformation gradients, cell by cell.
#pragma once

#include <array>

#include "solver/mesh/grid.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// Phi of each node from the cells about it: 1 in the first material, -1 in the second.
/// \param fraction of the first material in each cell
NodeField indicator(const Grid& grid, const CellField& fraction);

/// Green-St. Venant strain E11, E22, E12 of each cell (paper eq. 30, 48).
/// \param f deformation gradient of each cell
Lattice<std::array<double, 3>> strains(const Lattice<Eigen::Matrix2d>& f);

CellField norms(const Lattice<std::array<double, 3>>& strain, StrainNorm norm);

}  // namespace crawford
