/// The face that every truth shows: fields by name, at points, at a time.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crawford::reference {

/// What a truth knows at a point. Names are those of the snapshot's data sets (docs/output.md),
/// with _x, _y, _xx, _xy, ... for components; units are SI, "1" for a pure number.
struct Field {
    std::string name, unit, meaning;
};

/// Fields at points.
class FieldTable {
public:
    /// \param values points x fields, columns in the order of `fields`
    FieldTable(std::vector<Field> fields, Eigen::MatrixXd values);

    const std::vector<Field>& fields() const { return fields_; }
    const Eigen::MatrixXd& values() const { return values_; }  ///< points x fields

    /// One field at all points.
    /// \throws InputError where there is no such field, naming the nearest.
    std::vector<double> column(std::string_view field) const;
    /// Several fields, all of the first point, then all of the next; \see column
    std::vector<double> columns(std::initializer_list<std::string_view> fields) const;

private:
    Eigen::Index index(std::string_view field) const;

    std::vector<Field> fields_;
    Eigen::MatrixXd values_;
};

/// From one number to another, both included; without bounds if not given.
struct Interval {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
};

/// Where and when a truth holds.
struct Domain {
    Interval x{};     ///< [m]
    Interval y{};     ///< [m], counted from `surface` where there is one
    Interval time{};  ///< [s]
    /// Height of the surface [m] at (x [m], t [s]), where it is not level.
    std::function<double(double x, double t)> surface{};
};

/// One exact solution with all its parameters given. A value: copies share nothing that changes.
class Truth {
public:
    /// points [m] and t [s] -> values, points x fields
    using Evaluate = std::function<Eigen::MatrixXd(std::span<const Eigen::Vector2d>, double t)>;

    Truth(std::vector<Field> fields, Domain domain, Evaluate evaluate);

    const std::vector<Field>& fields() const { return fields_; }
    const Domain& domain() const { return domain_; }

    /// All fields at points (x, y) [m], in any order, at a time [s] (which a steady truth ignores).
    /// \throws InputError for a point or time outside the domain, naming it.
    /// \throws NumericalFailure naming field and point, if a value is not finite, or where no solution
    /// is found.
    FieldTable values(std::span<const Eigen::Vector2d> points, double t = 0.0) const;

private:
    void require_within(std::span<const Eigen::Vector2d> points, double t) const;
    void require_finite(const Eigen::MatrixXd& values, std::span<const Eigen::Vector2d> points,
                        double t) const;

    std::vector<Field> fields_;
    Domain domain_;
    Evaluate evaluate_;
};

/// The points (0, y), for a truth that does not depend on x.
std::vector<Eigen::Vector2d> points_at(std::span<const double> y);

}  // namespace crawford::reference
