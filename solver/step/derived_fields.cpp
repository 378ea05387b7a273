#include "solver/step/derived_fields.hpp"

#include <algorithm>
#include <cmath>

#include "solver/reference_map/reference_map.hpp"

namespace crawford {

NodeField indicator(const Grid& grid, const CellField& fraction) {
    NodeField sum(grid.node_columns(), grid.rows() + 1);
    NodeField cells(grid.node_columns(), grid.rows() + 1);
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j)
            for (const Node& node : corners(grid, i, j)) {
                sum(node.i, node.j) += 2.0 * fraction(i, j) - 1.0;
                cells(node.i, node.j) += 1.0;
            }
    for (size_t k = 0; k < sum.values().size(); ++k) sum.values()[k] /= cells.values()[k];
    return sum;
}

Lattice<std::array<double, 3>> strains(const Lattice<Eigen::Matrix2d>& f) {
    Lattice<std::array<double, 3>> result(f.columns(), f.rows());
    for (size_t k = 0; k < f.values().size(); ++k) {
        const Eigen::Matrix2d e = green_strain(f.values()[k]);
        result.values()[k] = {e(0, 0), e(1, 1), e(0, 1)};
    }
    return result;
}

CellField norms(const Lattice<std::array<double, 3>>& strain, StrainNorm norm) {
    CellField result(strain.columns(), strain.rows());
    for (size_t k = 0; k < strain.values().size(); ++k) {
        const auto& [e11, e22, e12] = strain.values()[k];
        result.values()[k] = norm == StrainNorm::frobenius
                                 ? std::sqrt(e11 * e11 + e22 * e22 + 2.0 * e12 * e12)
                                 : std::max({std::abs(e11), std::abs(e22), std::abs(e12)});
    }
    return result;
}

}  // namespace crawford
