#include "solver/reference_map/reference_map.hpp"

#include <Eigen/LU>

#include "solver/mesh/weno.hpp"

namespace crawford {

namespace {

/// A nodal vector, also beyond the sides of the window.
Vector beyond(const Grid& grid, const NodeVectors& values, int i, int j) {
    const NodeColumn column = grid.node_column(i);
    const Vector& value = values(column.index, j);
    return {column.mirrored ? -value.x() : value.x(), value.y()};
}

Vector eno2(const Vector& far, const Vector& near, const Vector& ahead) {
    return {crawford::eno2({far.x(), near.x(), ahead.x()}),
            crawford::eno2({far.y(), near.y(), ahead.y()})};
}

/// Undivided upwind derivative of values[-2..2] about the middle one.
template <class At>
Vector upwind(const At& at, double velocity) {
    if (velocity > 0.0) return eno2(at(-1) - at(-2), at(0) - at(-1), at(1) - at(0));
    return eno2(at(2) - at(1), at(1) - at(0), at(0) - at(-1));
}

/// The value in row j, extrapolated by a parabola above the surface and below the bottom: by a
/// straight line, the row beside them would be first order and F in its cells would not converge.
Vector in_column(const Grid& grid, const NodeVectors& values, int i, int j) {
    const int top = grid.rows();
    if (j > top + 1) return values(i, top);  // never upwind of anything
    if (j > top) return 3.0 * values(i, top) - 3.0 * values(i, top - 1) + values(i, top - 2);
    if (j < 0) return 3.0 * values(i, 0) - 3.0 * values(i, 1) + values(i, 2);
    return values(i, j);
}

/// Slope of the surface at a node column, from the heights beside it.
double node_slope(const Grid& grid, const SurfaceField& surface, int i) {
    const int n = grid.cell_columns();
    if (grid.sides() == Sides::mirror && (i == 0 || i == n)) return 0.0;
    const int left = i > 0 ? i - 1 : n - 1;
    const auto rise = [&](int cell) {  // per step of i
        return grid.slope(surface, cell) * (grid.dx(cell) / grid.metric_x(i));
    };
    return 0.5 * (rise(left) + rise(i));
}

}  // namespace

void advance_reference_map(const Grid& grid, const SolidMotion& motion, double dt,
                           const NodeVectors& carried, NodeVectors& shift) {
    NodeVectors next = shift;
    for (int i = 0; i < grid.node_columns(); ++i) {
        const double slope = node_slope(grid, motion.surface, i);
        for (int j = 1; j <= grid.rows(); ++j) {
            const Vector relative = relative_velocity(motion, {i, j});
            const double across = relative.x() / grid.metric_x(i);
            const double upward = (relative.y() - slope * relative.x()) / grid.metric(j);
            Vector rate = -motion.velocity(i, j);
            rate -=
                upward * upwind([&](int k) { return in_column(grid, carried, i, j + k); }, upward);
            if (grid.cell_columns() > 1)
                rate -=
                    across * upwind([&](int k) { return beyond(grid, carried, i + k, j); }, across);
            next(i, j) += dt * rate;
        }
    }
    shift = std::move(next);
}

Lattice<Eigen::Matrix2d> deformation_gradient(const Grid& grid, const SurfaceField& surface,
                                              const NodeVectors& shift) {
    Lattice<Eigen::Matrix2d> f(grid.cell_columns(), grid.rows(), Eigen::Matrix2d::Identity());
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const Cell cell(grid, surface, i, j);
            Eigen::Matrix2d grad_xi = Eigen::Matrix2d::Identity();
            grad_xi += gradient(cell, gather(shift, corners(grid, i, j)), cell_centre);
            f(i, j) = grad_xi.inverse();
        }
    return f;
}

}  // namespace crawford
