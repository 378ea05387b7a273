#include "solver/stress/neighbours.hpp"

#include <algorithm>

namespace crawford {

StressNeighbours::Place StressNeighbours::beside(int i, int j, int offset) const {
    const int n = grid_.cell_columns();
    const int column = i + offset;
    if (column >= 0 && column < n) return {column, j, true, false};
    if (grid_.sides() == Sides::periodic) return {((column % n) + n) % n, j, true, false};
    const int folded = column < 0 ? -1 - column : 2 * n - 1 - column;
    return {folded, j, folded >= 0 && folded < n, true};
}

StressNeighbours::Place StressNeighbours::above(int i, int j, int offset) const {
    const int row = j + offset;
    return {i, row, row >= 0 && row < grid_.rows(), false};
}

template <class Value, class Find, class Read>
Neighbourhood<Value> StressNeighbours::gather(int i, int j, const Find& find,
                                              const Read& read) const {
    Neighbourhood<Value> result{};
    result.value[2] = read({i, j, true, false});
    result.open[2] = true;
    for (const int direction : {-1, 1})
        for (int distance = 1; distance <= 2; ++distance) {
            const auto k = size_t(2 + direction * distance);
            const Place at = find(i, j, direction * distance);
            result.open[k] = result.open[size_t(int(k) - direction)] && at.exists &&
                             materials_.same_material(i, j, at.i, at.j);
            if (!result.open[k]) break;
            result.value[k] = read(at);
        }
    return result;
}

Deviator StressNeighbours::read(const StressField& stress, int point, int i, int j,
                                const Place& at) const {
    // Points come in pairs beside each other: across a plane of symmetry each meets its partner.
    const int source = at.mirrored && stress.points() > 1 ? point ^ 1 : point;
    Deviator s = stress.deviator[size_t(source)](at.i, at.j);
    if (at.mirrored) s.s12 = -s.s12;
    const double here = materials_.shear_modulus(i, j);
    const double there = materials_.shear_modulus(at.i, at.j);
    return here < there ? (here / there) * s : s;
}

Neighbourhood<Deviator> StressNeighbours::along_row(const StressField& stress, int point, int i,
                                                    int j) const {
    return gather<Deviator>(
        i, j, [&](int ci, int cj, int offset) { return beside(ci, cj, offset); },
        [&](const Place& at) { return read(stress, point, i, j, at); });
}

Neighbourhood<Deviator> StressNeighbours::along_column(const StressField& stress, int point, int i,
                                                       int j) const {
    return gather<Deviator>(
        i, j, [&](int ci, int cj, int offset) { return above(ci, cj, offset); },
        [&](const Place& at) { return read(stress, point, i, j, at); });
}

Neighbourhood<double> StressNeighbours::along_row(const CellField& pressure, int i, int j) const {
    return gather<double>(
        i, j, [&](int ci, int cj, int offset) { return beside(ci, cj, offset); },
        [&](const Place& at) { return pressure(at.i, at.j); });
}

Neighbourhood<double> StressNeighbours::along_column(const CellField& pressure, int i,
                                                     int j) const {
    return gather<double>(
        i, j, [&](int ci, int cj, int offset) { return above(ci, cj, offset); },
        [&](const Place& at) { return pressure(at.i, at.j); });
}

}  // namespace crawford
