#include "reference/carried_profile.hpp"

#include <cmath>
#include <numbers>

#include "reference/require.hpp"

namespace crawford::reference {

namespace {

struct ValueAndSlope {
    double value, slope;
};

ValueAndSlope along_column(const ProfileShape& shape, double y) {
    const double z = (y - shape.middle) / shape.width;
    switch (shape.column) {
        case ColumnShape::exponential:
            return {std::exp(z), std::exp(z) / shape.width};
        case ColumnShape::bump:
            return {std::exp(-z * z), -2.0 * z * std::exp(-z * z) / shape.width};
        case ColumnShape::constant:
            break;
    }
    return {1.0, 0.0};
}

}  // namespace

CarriedProfile::CarriedProfile(const ProfileShape& shape) : shape_(shape) {
    require_finite("amplitude", shape.amplitude);
    require_not_negative("period", shape.period);
    require_finite("phase", shape.phase);
    require_finite("middle", shape.middle);
    require_positive("width", shape.width);
    if (shape.period > 0.0) wave_number_ = 2.0 * std::numbers::pi / shape.period;
}

double CarriedProfile::value(const Eigen::Vector2d& x) const {
    return shape_.amplitude * std::cos(wave_number_ * x.x() + shape_.phase) *
           along_column(shape_, x.y()).value;
}

Eigen::Vector2d CarriedProfile::gradient(const Eigen::Vector2d& x) const {
    const double angle = wave_number_ * x.x() + shape_.phase;
    const auto column = along_column(shape_, x.y());
    return shape_.amplitude * Eigen::Vector2d(-wave_number_ * std::sin(angle) * column.value,
                                              std::cos(angle) * column.slope);
}

double CarriedProfile::rate(const Eigen::Vector2d& x, const Eigen::Vector2d& material,
                            const Eigen::Vector2d& point) const {
    return -(material - point).dot(gradient(x));
}

}  // namespace crawford::reference
