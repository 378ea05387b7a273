/// What truths are told in: fields that several share, and a row of their values.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "reference/plane_strain_stress.hpp"
#include "reference/truth.hpp"

namespace crawford::reference {

using Fields = std::vector<Field>;

Fields scalar_field(const std::string& name, const std::string& unit, const std::string& meaning);
Fields temperature_field();  ///< temperature [K]
Fields surface_field();      ///< surface [m]
/// name_x, name_y
Fields vector_fields(const std::string& name, const std::string& unit, const std::string& meaning);
/// name_xx, name_xy, name_yx, name_yy
Fields matrix_fields(const std::string& name, const std::string& unit, const std::string& meaning);
/// name_xx, name_yy, name_xy
Fields symmetric_fields(const std::string& name, const std::string& unit,
                        const std::string& meaning);
/// stress_xx, stress_yy, stress_zz, stress_xy, pressure [Pa]
Fields stress_fields();
/// What follows a motion: velocity, reference_map, displacement, deformation_gradient.
Fields motion_fields();

Fields joined(std::initializer_list<Fields> groups);

/// The values of one point, appended in the order of the fields.
class Row {
public:
    Row& add(double value);
    Row& add(const Eigen::Vector2d& vector);            ///< x, y
    Row& add(const Eigen::Matrix2d& matrix);            ///< xx, xy, yx, yy
    Row& add_symmetric(const Eigen::Matrix2d& matrix);  ///< xx, yy, xy
    Row& add(const PlaneStrainStress& stress);          ///< stress_fields()

    const std::vector<double>& values() const { return values_; }

private:
    std::vector<double> values_;
};

/// A truth that answers point by point.
Truth pointwise(Fields fields, Domain domain,
                std::function<Row(const Eigen::Vector2d& point, double t)> row);

/// A lattice of points, three across and four up, the corners among them.
std::vector<Eigen::Vector2d> lattice(Interval x, Interval y);

}  // namespace crawford::reference
