#include "solver/element/checkerboard.hpp"

namespace crawford {

namespace {

/// Calls act(i, j, sign, corner of the patch) for the four cells.
template <class Act>
void each_cell(const Patch& patch, const Act& act) {
    for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) act(patch.i + a, patch.j + b, a == b ? 1.0 : -1.0, 3 * b + a);
}

}  // namespace

std::array<Node, 9> patch_nodes(const Grid& grid, const Patch& patch) {
    const int middle = grid.right_node(patch.i);
    const std::array<int, 3> columns{patch.i, middle, grid.right_node(middle)};
    std::array<Node, 9> nodes;
    for (int k = 0; k < 9; ++k) nodes[size_t(k)] = {columns[size_t(k % 3)], patch.j + k / 3};
    return nodes;
}

std::vector<Patch> all_patches(const Grid& grid) {
    std::vector<Patch> patches;
    for (int i = 0; i + 1 < grid.cell_columns(); i += 2)
        for (int j = grid.rows() - 2; j >= 0; j -= 2) patches.push_back({i, j});
    return patches;
}

Checkerboard::Checkerboard(const Grid& grid, const MaterialMap& materials, Element element)
    : grid_(grid), materials_(materials) {
    if (element == Element::bbar) patches_ = all_patches(grid);
}

bool Checkerboard::is_one_material(const Patch& patch) const {
    const CellField& fraction = materials_.fraction();
    bool same = true;
    each_cell(patch, [&](int i, int j, double, int) {
        same = same && fraction(i, j) == fraction(patch.i, patch.j);
    });
    return same;
}

void Checkerboard::remove_from(CellField& field) const {
    for (const Patch& patch : patches_) {
        if (!is_one_material(patch)) continue;
        double alternating = 0.0;
        double whole = 0.0;
        each_cell(patch, [&](int i, int j, double sign, int) {
            const double area = grid_.height(j) * (grid_.dx(i) / grid_.dx());
            alternating += sign * area * field(i, j);
            whole += area;
        });
        each_cell(patch, [&](int i, int j, double sign, int) {
            field(i, j) -= sign * alternating / whole;
        });
    }
}

Eigen::Matrix<double, 18, 1> Checkerboard::unit_force(const Patch& patch,
                                                      const SurfaceField& surface) const {
    Eigen::Matrix<double, 18, 1> force = Eigen::Matrix<double, 18, 1>::Zero();
    each_cell(patch, [&](int i, int j, double sign, int corner) {
        const Cell cell(grid_, surface, i, j);
        const auto hats = hat_gradients(cell, cell_centre);
        for (int k = 0; k < 4; ++k)
            force.segment<2>(2 * (corner + 3 * (k / 2) + k % 2)) +=
                sign * cell.area() * hats[size_t(k)];
    });
    return force;
}

double Checkerboard::area(const Patch& patch) const {
    return (grid_.dx(patch.i) + grid_.dx(patch.i + 1)) *
           (grid_.height(patch.j) + grid_.height(patch.j + 1));
}

}  // namespace crawford
