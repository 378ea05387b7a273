#include "solver/materials/disc_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

namespace {

double cross(const Vector& p, const Vector& q) {
    return p.x() * q.y() - p.y() * q.x();
}

double sector(const Vector& p, const Vector& q, double radius) {
    return 0.5 * radius * radius * std::atan2(cross(p, q), p.dot(q));
}

/// Signed area shared by the disc and the triangle (origin, p, q): sectors where the edge runs
/// outside, a triangle where it runs inside.
double edge_overlap(const Vector& p, const Vector& q, double radius) {
    const Vector d = q - p;
    const double a = d.squaredNorm();
    const double b = p.dot(d);
    const double discriminant = b * b - a * (p.squaredNorm() - radius * radius);
    if (a == 0.0 || discriminant <= 0.0) return sector(p, q, radius);
    const double enters = (-b - std::sqrt(discriminant)) / a;
    const double leaves = (-b + std::sqrt(discriminant)) / a;
    if (leaves <= 0.0 || enters >= 1.0) return sector(p, q, radius);
    const Vector first = p + std::max(enters, 0.0) * d;
    const Vector last = p + std::min(leaves, 1.0) * d;
    return sector(p, first, radius) + 0.5 * cross(first, last) + sector(last, q, radius);
}

}  // namespace

double disc_overlap(const std::array<Vector, 4>& corners, double radius) {
    double area = 0.0;
    for (size_t k = 0; k < 4; ++k) area += edge_overlap(corners[k], corners[(k + 1) % 4], radius);
    return area;
}

}  // namespace crawford
