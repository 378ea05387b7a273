#include "solver/guards/crossed.hpp"

#include <algorithm>
#include <cmath>

#include "solver/guards/steady_slab.hpp"

namespace crawford {

double front_speed(double burn_rate, double z, double slope) {
    return burn_rate * std::max(std::sqrt(std::max(z, 0.0)), slope / std::hypot(1.0, slope));
}

double front_crossing_limit(Stepping scheme) {
    return scheme == Stepping::euler ? 0.9 : 3.0;
}

Crossing::Crossing(const Scene& scene, const Grid& grid)
    : grid_(grid),
      rows_in_a_metre_(size_t(grid.rows()) + 1),
      columns_in_a_metre_(1.0 / narrowest_column(grid)),
      activation_(largest_activation(scene)),
      cold_(scene.bottom.temperature),
      front_limit_(front_crossing_limit(scene.time.scheme)),
      mechanics_every_(scene.time.mechanics_every) {
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
            worst.columns = std::max(worst.columns,
                                     mechanics_every_ * std::abs(v.x()) * dt * columns_in_a_metre_);
            worst.rows = std::max(worst.rows, mechanics_every_ * std::abs(v.y() * dt + fall) *
                                                  rows_in_a_metre_[size_t(j)]);
        }
    }
    worst.by_front = by_front(before, after);
    return worst;
}

double Crossing::by_front(const SurfaceField& before, const State& after) const {
    if (grid_.cell_columns() == 1) return 0.0;
    const double fall = mean_height(grid_, before) - mean_height(grid_, after.surface);
    double hottest = cold_;
    const NodeField& t = after.temperature;
    for (int i = 0; i < t.columns(); ++i) hottest = std::max(hottest, t(i, t.rows() - 1));
    const double z = zeldovich_number(activation_, hottest, cold_);
    return columns_in_a_metre_ *
           front_speed(std::max(fall, 0.0), z, largest_slope(grid_, after.surface));
}

double Crossing::share_of_limit(const Crossed& crossed) const {
    return std::max({crossed.columns, crossed.rows, crossed.by_front / front_limit_});
}

}  // namespace crawford
