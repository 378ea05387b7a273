#include "solver/guards/crossed.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

Crossing::Crossing(const Grid& grid)
    : rows_in_a_metre_(size_t(grid.rows()) + 1), columns_in_a_metre_(1.0 / narrowest_column(grid)) {
    for (int j = 0; j <= grid.rows(); ++j)
        rows_in_a_metre_[size_t(j)] = 1.0 / std::min(grid.height(std::max(j - 1, 0)),
                                                     grid.height(std::min(j, grid.rows() - 1)));
}

Crossed Crossing::of(const SurfaceField& before, const State& after) const {
    const double dt = after.length;
    Crossed worst;
    for (int i = 0; i < int(after.surface.size()); ++i) {
        const double fall = before[size_t(i)] - after.surface[size_t(i)];
        worst.rows = std::max(worst.rows, std::abs(fall) * rows_in_a_metre_.back());
        if (after.velocity.empty()) continue;
        for (int j = 0; j < int(rows_in_a_metre_.size()); ++j) {
            const Vector& v = after.velocity(i, j);
            worst.columns = std::max(worst.columns, std::abs(v.x()) * dt * columns_in_a_metre_);
            worst.rows =
                std::max(worst.rows, std::abs(v.y() * dt + fall) * rows_in_a_metre_[size_t(j)]);
        }
    }
    return worst;
}

}  // namespace crawford
