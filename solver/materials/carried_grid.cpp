#include "solver/materials/carried_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace crawford {

namespace {

double cross(const Vector& p, const Vector& q) {
    return p.x() * q.y() - p.y() * q.x();
}

}  // namespace

CarriedGrid::CarriedGrid(const Grid& grid, const SurfaceField& surface, const NodeVectors* shift)
    : grid_(grid), surface_(surface), shift_(shift) {
    if (!shift_) return;
    for (const Vector& s : shift_->values()) {
        least_ = least_.cwiseMin(s);
        most_ = most_.cwiseMax(s);
    }
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j)
            if (!(area(i, j) > 0.0))
                throw NumericalFailure(
                    {.kind = FailureFields::Kind::beyond_limit,
                     .module = "morphology",
                     .quantity = "area of what the reference map turns inside out",
                     .value = area(i, j),
                     .unit = "m2",
                     .limit = FailureLimit{.value = 0.0, .is_least = true},
                     .place = FailurePlace{"cell", i, j},
                     .advice = "reduce time.step, or take morphology.indicator = \"laboratory\""});
}

std::array<Vector, 4> CarriedGrid::cell(int i, int j, const Vector& origin) const {
    const int right = grid_.right_node(i);
    const double x = grid_.x(i) - origin.x();
    const double y_left = surface_[size_t(i)] - origin.y();
    const double y_right = surface_[size_t(right)] - origin.y();
    const double low = grid_.eta(j);
    const double high = grid_.eta(j + 1);
    return {Vector(x, y_left + low) + shift(i, j),
            Vector(x + grid_.dx(i), y_right + low) + shift(right, j),
            Vector(x + grid_.dx(i), y_right + high) + shift(right, j + 1),
            Vector(x, y_left + high) + shift(i, j + 1)};
}

Segment CarriedGrid::top(int i, const Vector& origin) const {
    const auto corner = cell(i, grid_.rows() - 1, origin);
    return {corner[3], corner[2]};
}

/// Half the cross product of the diagonals; what the shift adds to it comes apart, so that a grid
/// at rest has the areas of its cells to the last bit.
double CarriedGrid::area(int i, int j) const {
    const double at_rest = grid_.dx(i) * (grid_.eta(j + 1) - grid_.eta(j));
    if (!shift_) return at_rest;
    const int right = grid_.right_node(i);
    const double rise = surface_[size_t(right)] - surface_[size_t(i)];
    const double height = grid_.height(j);
    const Vector up(grid_.dx(i), height + rise);     // from corner 0 to corner 2
    const Vector down(-grid_.dx(i), height - rise);  // from corner 1 to corner 3
    const Vector more_up = shift(right, j + 1) - shift(i, j);
    const Vector more_down = shift(i, j + 1) - shift(right, j);
    return at_rest +
           0.5 * (cross(up, more_down) + cross(more_up, down) + cross(more_up, more_down));
}

Vector CarriedGrid::lowest() const {
    return Vector(grid_.x(0), std::ranges::min(surface_) - grid_.depth()) + least_;
}

Vector CarriedGrid::highest() const {
    return Vector(grid_.x(0) + grid_.width(), std::ranges::max(surface_)) + most_;
}

std::pair<int, int> CarriedGrid::columns(double left, double right) const {
    const double from = (left - most_.x() - grid_.x(0)) / grid_.dx();
    const double to = (right - least_.x() - grid_.x(0)) / grid_.dx();
    return {std::max(int(std::floor(from)), 0), std::min(int(std::ceil(to)), grid_.cell_columns())};
}

std::pair<int, int> CarriedGrid::rows(int i, double low, double high) const {
    const auto [down, up] = std::minmax(surface_[size_t(i)], surface_[size_t(grid_.right_node(i))]);
    int first = 0;
    int end = grid_.rows();
    while (first < end && up + most_.y() + grid_.eta(first + 1) < low) ++first;
    while (first < end && down + least_.y() + grid_.eta(end - 1) > high) --end;
    return {first, end};
}

}  // namespace crawford
