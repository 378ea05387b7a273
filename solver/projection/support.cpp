#include "solver/projection/support.hpp"

namespace crawford {

std::vector<bool> held_unknowns(const Grid& grid, Support support) {
    const int rows = grid.rows() + 1;
    const int columns = grid.node_columns();
    std::vector<bool> held(size_t(2 * columns * rows), false);
    const auto hold = [&](int i, int j, int component) {
        held[size_t(2 * (i * rows + j) + component)] = true;
    };
    for (int i = 0; i < columns; ++i) {
        hold(i, 0, 1);
        if (support == Support::clamped) hold(i, 0, 0);
    }
    if (grid.sides() == Sides::mirror)
        for (int j = 0; j < rows; ++j) {
            hold(0, j, 0);
            hold(columns - 1, j, 0);
        }
    else
        hold(columns / 2, 0, 0);  // x = 0: the solid may not drift sideways
    return held;
}

}  // namespace crawford
