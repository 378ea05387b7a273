#include "reference/fade.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

Fade::Fade(double whole, double gone) : whole_(whole), gone_(gone) {
    require_positive("whole", whole);
    require_positive("gone", gone);
    if (gone <= whole)
        throw std::invalid_argument(
            fmt::format("gone = {} must be more than whole, {}", gone, whole));
}

/// 1 - t^4 (35 - 84 t + 70 t^2 - 20 t^3), t from 0 at `whole` to 1 at `gone`.
Fade::Value Fade::at(double x, double y) const {
    const double r = std::hypot(x, y);
    if (r <= whole_) return {1.0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    if (r >= gone_) return {0.0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    const double width = gone_ - whole_;
    const double t = (r - whole_) / width;
    const double s = 1.0 - t;
    const double first = -140.0 * std::pow(t * s, 3) / width;
    const double second = -420.0 * t * t * s * s * (s - t) / (width * width);
    const Eigen::Vector2d outward(x / r, y / r);
    const Eigen::Matrix2d along = outward * outward.transpose();
    return {1.0 - std::pow(t, 4) * (35.0 - 84.0 * t + 70.0 * t * t - 20.0 * t * t * t),
            first * outward, second * along + first / r * (Eigen::Matrix2d::Identity() - along)};
}

}  // namespace crawford::reference
