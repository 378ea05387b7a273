#include "solver/materials/strip_overlap.hpp"

#include <algorithm>

namespace crawford {

namespace {

/// Integral of clamp(x, -half_width, half_width) dy along an edge: piecewise linear between where
/// the edge starts, crosses the sides of the strip, and ends.
double edge_overlap(const Vector& p, const Vector& q, double half_width) {
    const Vector d = q - p;
    std::array<double, 4> along{0.0, 0.0, 0.0, 1.0};
    if (d.x() != 0.0) {
        along[1] = std::clamp((-half_width - p.x()) / d.x(), 0.0, 1.0);
        along[2] = std::clamp((half_width - p.x()) / d.x(), 0.0, 1.0);
        if (along[1] > along[2]) std::swap(along[1], along[2]);
    }
    const auto clamped = [&](double t) {
        return std::clamp(p.x() + t * d.x(), -half_width, half_width);
    };
    double integral = 0.0;
    for (size_t k = 0; k < 3; ++k)
        integral +=
            0.5 * (clamped(along[k]) + clamped(along[k + 1])) * (along[k + 1] - along[k]) * d.y();
    return integral;
}

}  // namespace

/// Green's theorem: the integral of f(x) dy around a polygon is that of f' over it, and f = clamp
/// has f' = 1 in the strip and 0 outside.
double strip_overlap(const std::array<Vector, 4>& corners, double half_width) {
    double area = 0.0;
    for (size_t k = 0; k < 4; ++k)
        area += edge_overlap(corners[k], corners[(k + 1) % 4], half_width);
    return area;
}

}  // namespace crawford
