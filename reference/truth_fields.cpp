#include "reference/truth_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace crawford::reference {

namespace {

Fields components(const std::string& name, const std::string& unit, const std::string& meaning,
                  std::initializer_list<const char*> suffixes) {
    Fields fields;
    for (const char* suffix : suffixes)
        fields.push_back({fmt::format("{}_{}", name, suffix), unit, meaning});
    return fields;
}

}  // namespace

Fields scalar_field(const std::string& name, const std::string& unit, const std::string& meaning) {
    return {{name, unit, meaning}};
}

Fields temperature_field() {
    return scalar_field("temperature", "K", "T");
}

Fields surface_field() {
    return scalar_field("surface", "m", "height of the surface at x, phi");
}

Fields vector_fields(const std::string& name, const std::string& unit, const std::string& meaning) {
    return components(name, unit, meaning, {"x", "y"});
}

Fields matrix_fields(const std::string& name, const std::string& unit, const std::string& meaning) {
    return components(name, unit, meaning, {"xx", "xy", "yx", "yy"});
}

Fields symmetric_fields(const std::string& name, const std::string& unit,
                        const std::string& meaning) {
    return components(name, unit, meaning, {"xx", "yy", "xy"});
}

Fields stress_fields() {
    Fields fields =
        components("stress", "Pa", "Cauchy stress, tension positive", {"xx", "yy", "zz", "xy"});
    fields.push_back({"pressure", "Pa", "-(stress_xx + stress_yy + stress_zz)/3"});
    return fields;
}

Fields motion_fields() {
    return joined({vector_fields("velocity", "m/s", "of the material"),
                   vector_fields("reference_map", "m", "xi: where the material was at the start"),
                   vector_fields("displacement", "m", "place less reference map"),
                   matrix_fields("deformation_gradient", "1", "F = d(x)/d(xi)")});
}

Fields joined(std::initializer_list<Fields> groups) {
    Fields all;
    for (const Fields& group : groups) all.insert(all.end(), group.begin(), group.end());
    return all;
}

Row& Row::add(double value) {
    values_.push_back(value);
    return *this;
}

Row& Row::add(const Eigen::Vector2d& vector) {
    return add(vector.x()).add(vector.y());
}

Row& Row::add(const Eigen::Matrix2d& matrix) {
    return add(matrix(0, 0)).add(matrix(0, 1)).add(matrix(1, 0)).add(matrix(1, 1));
}

Row& Row::add_symmetric(const Eigen::Matrix2d& matrix) {
    return add(matrix(0, 0)).add(matrix(1, 1)).add(matrix(0, 1));
}

Row& Row::add(const PlaneStrainStress& stress) {
    return add(stress.xx).add(stress.yy).add(stress.zz).add(stress.xy).add(stress.pressure());
}

Truth pointwise(Fields fields, Domain domain,
                std::function<Row(const Eigen::Vector2d& point, double t)> row) {
    const auto count = static_cast<Eigen::Index>(fields.size());
    auto evaluate = [count, row = std::move(row)](std::span<const Eigen::Vector2d> points,
                                                  double t) {
        Eigen::MatrixXd table(static_cast<Eigen::Index>(points.size()), count);
        for (size_t k = 0; k < points.size(); ++k) {
            const Row values = row(points[k], t);
            if (static_cast<Eigen::Index>(values.values().size()) != count)
                throw std::logic_error(
                    fmt::format("{} values for {} fields", values.values().size(), count));
            std::ranges::copy(values.values(), table.row(static_cast<Eigen::Index>(k)).begin());
        }
        return table;
    };
    return {std::move(fields), std::move(domain), std::move(evaluate)};
}

std::vector<Eigen::Vector2d> lattice(Interval x, Interval y) {
    std::vector<Eigen::Vector2d> points;
    for (const double i : {0.0, 0.5, 1.0})
        for (const double j : {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0})
            points.emplace_back(x.from + i * (x.to - x.from), y.from + j * (y.to - y.from));
    return points;
}

}  // namespace crawford::reference
