#include "solver/stress/neighbours.hpp"

namespace crawford {

Reach::Place StressNeighbours::beside(int i, int j, int offset) const {
    const int n = grid_.cell_columns();
    const int column = i + offset;
    if (column >= 0 && column < n) return {column, j, true, false, 1.0};
    if (grid_.sides() == Sides::periodic) return {((column % n) + n) % n, j, true, false, 1.0};
    const int folded = column < 0 ? -1 - column : 2 * n - 1 - column;
    return {folded, j, folded >= 0 && folded < n, true, 1.0};
}

Reach::Place StressNeighbours::above(int i, int j, int offset) const {
    const int row = j + offset;
    return {i, row, row >= 0 && row < grid_.rows(), false, 1.0};
}

template <class Find>
Reach StressNeighbours::reach(int i, int j, const Find& find) const {
    const double here = materials_.shear_modulus(i, j);
    Reach result{};
    result.places[2] = {i, j, true, false, 1.0};
    for (const int direction : {-1, 1})
        for (int distance = 1; distance <= 2; ++distance) {
            Reach::Place at = find(direction * distance);
            at.open = at.open && materials_.same_material(i, j, at.i, at.j);
            if (!at.open) break;
            const double there = materials_.shear_modulus(at.i, at.j);
            at.share = here < there ? here / there : 1.0;
            result.places[size_t(2 + direction * distance)] = at;
        }
    return result;
}

Reach StressNeighbours::along_row(int i, int j) const {
    return reach(i, j, [&](int offset) { return beside(i, j, offset); });
}

Reach StressNeighbours::along_column(int i, int j) const {
    return reach(i, j, [&](int offset) { return above(i, j, offset); });
}

}  // namespace crawford
