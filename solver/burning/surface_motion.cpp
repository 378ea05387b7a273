#include "solver/burning/surface_motion.hpp"

#include <algorithm>
#include <cmath>

#include "solver/mesh/weno.hpp"

namespace crawford {

namespace {

// Slopes are of order one: a change of slope of 1e-3 between neighbours is smooth.
constexpr double smooth_slope_squared = 1e-6;

struct Slopes {
    double left, right;  // one-sided: from the left and from the right
};

Slopes one_sided_slopes(const Grid& grid, const SurfaceField& surface, int i) {
    const auto height = [&](int column) { return surface[size_t(grid.node_column(column).index)]; };
    std::array<double, 4> slope;  // of the segments i-2 .. i+1
    for (int k = 0; k < 4; ++k)
        slope[size_t(k)] = (height(i + k - 1) - height(i + k - 2)) / grid.dx();
    return {weno3({slope[0], slope[1], slope[2]}, smooth_slope_squared),
            weno3({slope[3], slope[2], slope[1]}, smooth_slope_squared)};
}

}  // namespace

SurfaceField surface_rate(const Grid& grid, const SurfaceField& surface,
                          const SurfaceField& burn_rate,
                          const std::vector<Vector>& material_velocity) {
    SurfaceField rate(surface.size());
    for (int i = 0; i < grid.node_columns(); ++i) {
        const Slopes slope = one_sided_slopes(grid, surface, i);
        // Godunov: sqrt(1 + p^2) grows with |p|, so the surface takes the steeper of the slopes
        // that run into it.
        const double steepest = std::max({slope.left, -slope.right, 0.0});
        rate[size_t(i)] = -burn_rate[size_t(i)] * std::hypot(1.0, steepest);
        if (material_velocity.empty()) continue;
        const Vector& v = material_velocity[size_t(i)];
        rate[size_t(i)] += v.y() - v.x() * (v.x() > 0.0 ? slope.left : slope.right);
    }
    return rate;
}

}  // namespace crawford
