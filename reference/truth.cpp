#include "reference/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "reference/solved.hpp"

namespace crawford::reference {

namespace {

/// A point on an edge that rounding has put beyond it is within, by so much of the larger end.
bool within(const Interval& range, double value) {
    constexpr double round_off = 1e-12;
    const auto size = [](double end) { return std::isfinite(end) ? std::abs(end) : 0.0; };
    const double slack = round_off * std::max(size(range.from), size(range.to));
    return std::isfinite(value) && value >= range.from - slack && value <= range.to + slack;
}

std::string wanted(const Interval& range, const char* unit) {
    if (std::isinf(range.from) && std::isinf(range.to)) return "a finite number";
    if (std::isinf(range.to)) return fmt::format("at least {} {}", range.from, unit);
    if (std::isinf(range.from)) return fmt::format("at most {} {}", range.to, unit);
    return fmt::format("from {} to {} {}", range.from, range.to, unit);
}

std::string place(const Eigen::Vector2d& point) {
    return fmt::format("({}, {}) m", point.x(), point.y());
}

}  // namespace

FieldTable::FieldTable(std::vector<Field> fields, Eigen::MatrixXd values)
    : fields_(std::move(fields)), values_(std::move(values)) {
    if (values_.cols() != static_cast<Eigen::Index>(fields_.size()))
        throw std::logic_error(
            fmt::format("{} columns of values for {} fields", values_.cols(), fields_.size()));
}

Eigen::Index FieldTable::index(std::string_view field) const {
    const auto found = std::ranges::find(fields_, field, &Field::name);
    if (found != fields_.end()) return found - fields_.begin();
    std::vector<std::string> names;
    for (const Field& known : fields_) names.push_back(known.name);
    throw InputError(fmt::format("unknown field {}{}", field, suggestion(field, names)));
}

std::vector<double> FieldTable::column(std::string_view field) const {
    return columns({field});
}

std::vector<double> FieldTable::columns(std::initializer_list<std::string_view> fields) const {
    std::vector<Eigen::Index> wanted;
    for (const std::string_view field : fields) wanted.push_back(index(field));
    std::vector<double> values;
    for (Eigen::Index point = 0; point < values_.rows(); ++point)
        for (const Eigen::Index field : wanted) values.push_back(values_(point, field));
    return values;
}

Truth::Truth(std::vector<Field> fields, Domain domain, Evaluate evaluate)
    : fields_(std::move(fields)), domain_(std::move(domain)), evaluate_(std::move(evaluate)) {}

FieldTable Truth::values(std::span<const Eigen::Vector2d> points, double t) const {
    return solved([&] {
        require_within(points, t);
        FieldTable table(fields_, evaluate_(points, t));
        require_finite(table.values(), points, t);
        return table;
    });
}

void Truth::require_within(std::span<const Eigen::Vector2d> points, double t) const {
    if (!within(domain_.time, t))
        throw InputError(fmt::format("time = {} s must be {}", t, wanted(domain_.time, "s")));
    for (const Eigen::Vector2d& point : points) {
        if (!within(domain_.x, point.x()))
            throw InputError(
                fmt::format("point {}: x must be {}", place(point), wanted(domain_.x, "m")));
        const double surface = domain_.surface ? domain_.surface(point.x(), t) : 0.0;
        if (!within(domain_.y, point.y() - surface))
            throw InputError(fmt::format(
                "point {}: y{} must be {}", place(point),
                domain_.surface ? fmt::format(", counted from the surface at {} m,", surface) : "",
                wanted(domain_.y, "m")));
    }
}

void Truth::require_finite(const Eigen::MatrixXd& values, std::span<const Eigen::Vector2d> points,
                           double t) const {
    if (values.rows() != static_cast<Eigen::Index>(points.size()))
        throw std::logic_error(
            fmt::format("{} rows of values for {} points", values.rows(), points.size()));
    for (Eigen::Index k = 0; k < values.rows(); ++k)
        for (Eigen::Index field = 0; field < values.cols(); ++field)
            if (!std::isfinite(values(k, field)))
                throw NumericalFailure(fmt::format(
                    "{} = {} at point {}, time = {} s", fields_[static_cast<size_t>(field)].name,
                    values(k, field), place(points[static_cast<size_t>(k)]), t));
}

std::vector<Eigen::Vector2d> points_at(std::span<const double> y) {
    std::vector<Eigen::Vector2d> points;
    for (const double height : y) points.emplace_back(0.0, height);
    return points;
}

}  // namespace crawford::reference
