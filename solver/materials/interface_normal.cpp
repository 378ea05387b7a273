#include "solver/materials/interface_normal.hpp"

#include <algorithm>

namespace crawford {

namespace {

/// The cell column that stands for column i, which may lie beyond the sides.
int cell_column(const Grid& grid, int i) {
    const int n = grid.cell_columns();
    if (grid.sides() == Sides::periodic) return (i + n) % n;
    return std::clamp(i, 0, n - 1);
}

double centre(const Grid& grid, int j) {
    return 0.5 * (grid.eta(j) + grid.eta(j + 1));
}

}  // namespace

Vector interface_normal(const Grid& grid, const SurfaceField& surface, const CellField& fraction,
                        int i, int j) {
    const int below = std::max(j - 1, 0);
    const int above = std::min(j + 1, grid.rows() - 1);
    Vector rise = Vector::Zero();  // weighted: across the cells beside, up the cells about
    for (const int offset : {-1, 0, 1}) {
        const double weight = offset == 0 ? 0.5 : 0.25;
        const int row = std::clamp(j + offset, 0, grid.rows() - 1);
        const int column = cell_column(grid, i + offset);
        rise.x() += weight * (fraction(cell_column(grid, i + 1), row) -
                              fraction(cell_column(grid, i - 1), row));
        rise.y() += weight * (fraction(column, above) - fraction(column, below));
    }
    const Cell cell(grid, surface, i, j);
    const double height = centre(grid, above) - centre(grid, below);
    const double beside =
        0.5 * (grid.dx(cell_column(grid, i - 1)) + grid.dx(cell_column(grid, i + 1)));
    const Vector gradient =
        cell.physical(rise.x() * cell.dx / (cell.dx + beside), rise.y() / height * cell.height);
    const double length = gradient.norm() * cell.dx;
    constexpr double round_off = 1e-9;
    return length > round_off ? Vector(gradient.normalized()) : Vector::Zero();
}

}  // namespace crawford
