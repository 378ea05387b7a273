/// The bilinear element of the projection: where it integrates, and how stiff it is   (paper eq.
/// 40-42).
///
/// q1 is the paper's: exact integration, the stress at the centre. Its fully integrated dilatation
/// locks where K >> mu. B-bar (mean dilatation, Hughes 1980) replaces the dilatation by its mean
/// over the cell: K acts on one number a cell. On a parallelogram both are closed forms in the four
/// moments of the hat gradients.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/mesh/cell.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// Where an element carries its stress: points of equal weight.
const std::vector<Local>& stress_points(Element element);

struct Moduli {
    double bulk, shear;  ///< K, mu [Pa]
};

/// Rows and columns (node 0 x, node 0 y, node 1 x, ...) [Pa].
using ElementMatrix = Eigen::Matrix<double, 8, 8>;

/// Integral of grad N_a : C : grad N_b over a cell, C = 2 mu dev + K tr, plane strain.
ElementMatrix stiffness(Element element, const Cell& cell, const Moduli& moduli);

}  // namespace crawford
