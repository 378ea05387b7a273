#include "reference/sloped_heat.hpp"

#include <unsupported/Eigen/KroneckerProduct>

#include "reference/condensed_factor.hpp"

namespace crawford::reference {

/// Local nodes run along x first: a matrix over an element is a Kronecker product, y before x.
struct SlopedHeat::Column {
    const Material& material;
    double flux;           // Q [W/m^2]
    double width;          // [m]
    int first_slope;       // of its local nodes
    Eigen::ArrayXd slope;  // phi_x at the points of the rule
};

SlopedHeat::SlopedHeat(const SandwichGeometry& geometry, const SandwichFlame& flame,
                       TensorSpace space)
    : geometry_(geometry),
      flame_(flame),
      space_(std::move(space)),
      rule_(space_.basis().degree() + 4) {
    const LobattoBasis& basis = space_.basis();
    value_.resize(rule_.points.size(), basis.degree() + 1);
    derivative_.resize(rule_.points.size(), basis.degree() + 1);
    for (Eigen::Index g = 0; g < rule_.points.size(); ++g) {
        value_.row(g) = basis.values(rule_.points[g]).transpose();
        derivative_.row(g) = basis.derivatives(rule_.points[g]).transpose();
    }
    for (int c = 0; c < space_.elements_x(); ++c) {
        if (in_strip(geometry_, space_.element(c))) interface_column_ += basis.degree();
    }
}

Eigen::VectorXd SlopedHeat::surface_places() const {
    const LobattoBasis& basis = space_.basis();
    Eigen::VectorXd x(space_.columns());
    for (int c = 0; c < space_.elements_x(); ++c) {
        const auto element = space_.element(c);
        x.segment(c * basis.degree(), basis.degree() + 1) =
            element.left + element.width * (basis.points().array() + 1.0) / 2.0;
    }
    return x;
}

SlopedHeat::Column SlopedHeat::column(int index, const Eigen::VectorXd& slope) const {
    const int degree = space_.basis().degree();
    const auto element = space_.element(index);
    const bool inner = in_strip(geometry_, element);
    const int first = index * degree + (inner ? 0 : 1);
    return {material_of(geometry_, element), inner ? flame_.inner_flux : flame_.outer_flux,
            element.width, first, value_ * slope.segment(first, degree + 1)};
}

/// Integral of w dT/deta over an element, times rho c_p.
Eigen::MatrixXd SlopedHeat::convection(const Column& column) const {
    const LobattoBasis& basis = space_.basis();
    return column.material.density * column.material.specific_heat *
           Eigen::MatrixXd(Eigen::kroneckerProduct(
               basis.convection(), Eigen::MatrixXd(basis.mass() * column.width / 2.0)));
}

/// Integral of kappa grad w . grad T + rho c_p V w dT/deta, where d/dx|y = d/dx|eta - phi_x d/deta.
Eigen::MatrixXd SlopedHeat::matrix(const Column& column, double height, double rate) const {
    const LobattoBasis& basis = space_.basis();
    const Eigen::ArrayXd& p = column.slope;
    const Eigen::ArrayXd weights = rule_.weights.array();
    const Eigen::MatrixXd steep =
        value_.transpose() * ((1.0 + p * p) * weights * column.width / 2.0).matrix().asDiagonal() *
        value_;
    const Eigen::MatrixXd tilted =  // w_x against T
        derivative_.transpose() * (p * weights).matrix().asDiagonal() * value_;
    const Eigen::MatrixXd tilted_back = tilted.transpose();
    const Eigen::MatrixXd turn = basis.convection();  // w against T_eta
    const Eigen::MatrixXd turn_back = turn.transpose();
    Eigen::MatrixXd conducted =
        Eigen::kroneckerProduct(Eigen::MatrixXd(basis.mass() * height / 2.0),
                                Eigen::MatrixXd(basis.stiffness() * 2.0 / column.width));
    conducted += Eigen::kroneckerProduct(Eigen::MatrixXd(basis.stiffness() * 2.0 / height), steep);
    conducted -= Eigen::kroneckerProduct(turn, tilted);
    conducted -= Eigen::kroneckerProduct(turn_back, tilted_back);
    return column.material.thermal_conductivity * conducted + rate * convection(column);
}

/// (Q sqrt(1 + phi_x^2) + q_s rho V) dx, on the upper nodes of a topmost element.
Eigen::VectorXd SlopedHeat::entering(const Column& column, double rate) const {
    const Eigen::ArrayXd density =
        column.flux * (1.0 + column.slope.square()).sqrt() +
        column.material.heat_of_reaction * column.material.density * rate;
    return value_.transpose() * (density * rule_.weights.array() * column.width / 2.0).matrix();
}

Eigen::MatrixXd SlopedHeat::entering_of_slope(const Column& column) const {
    const Eigen::ArrayXd density =
        column.flux * column.slope / (1.0 + column.slope.square()).sqrt();
    return value_.transpose() *
           (density * rule_.weights.array() * column.width / 2.0).matrix().asDiagonal() * value_;
}

/// What a change of each local slope does to the forces on an element, local nodes x local slopes:
/// minus the derivative of its matrix times T.
Eigen::MatrixXd SlopedHeat::force_of_slope(const Column& column, double height,
                                           const Eigen::MatrixXd& temperature) const {
    const LobattoBasis& basis = space_.basis();
    const int n = basis.degree() + 1;
    // Points of the rule x rows of test functions in eta.
    const Eigen::MatrixXd across = value_ * temperature * basis.convection().transpose();
    const Eigen::MatrixXd along = derivative_ * temperature * basis.convection();
    const Eigen::MatrixXd down = value_ * temperature * basis.stiffness() * (2.0 / height);
    Eigen::MatrixXd forces(n * n, n);
    for (int k = 0; k < n; ++k) {
        const Eigen::ArrayXd change = rule_.weights.array() * value_.col(k).array();
        const Eigen::MatrixXd part =
            derivative_.transpose() * change.matrix().asDiagonal() * across +
            value_.transpose() * change.matrix().asDiagonal() * along -
            value_.transpose() * (change * column.slope * column.width).matrix().asDiagonal() *
                down;
        forces.col(k) = column.material.thermal_conductivity * part.reshaped();
    }
    return forces;
}

SlopedHeat::Response SlopedHeat::respond(const Eigen::VectorXd& slope, double rate) const {
    const int n = space_.basis().degree() + 1;
    std::vector<Column> columns;
    for (int c = 0; c < space_.elements_x(); ++c) columns.push_back(column(c, slope));
    const auto column_of = [&](int element) -> const Column& {
        return columns[static_cast<std::size_t>(element % space_.elements_x())];
    };

    std::vector<Eigen::MatrixXd> matrices;
    Eigen::VectorXd heat = Eigen::VectorXd::Zero(space_.nodes());
    for (int e = 0; e < space_.elements(); ++e) {
        const auto element = space_.element(e);
        matrices.push_back(matrix(column_of(e), element.height, rate));
        const std::vector<int> top(element.nodes.end() - n, element.nodes.end());
        if (is_top(e)) heat(top) += entering(column_of(e), rate);
    }
    const CondensedFactor factor(space_, matrices);
    const Eigen::VectorXd rise = factor.solve(heat);

    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(space_.nodes(), slopes() + 1);
    for (int e = 0; e < space_.elements(); ++e) {
        const Column& here = column_of(e);
        const auto element = space_.element(e);
        const Eigen::VectorXd local = rise(element.nodes);
        const auto affected = Eigen::seqN(here.first_slope, n);
        forces(element.nodes, affected) +=
            force_of_slope(here, element.height, local.reshaped(n, n));
        forces(element.nodes, slopes()) -= convection(here) * local;
        if (!is_top(e)) continue;
        const std::vector<int> top(element.nodes.end() - n, element.nodes.end());
        forces(top, affected) += entering_of_slope(here);
        forces(top, slopes()).array() += here.material.heat_of_reaction * here.material.density *
                                         space_.basis().mass().rowwise().sum().array() *
                                         here.width / 2.0;
    }
    const Eigen::MatrixXd moved = factor.surface(forces);
    const Eigen::VectorXd temperature = rise.array() + flame_.cold_temperature;
    return {temperature, temperature.tail(space_.columns()), moved.leftCols(slopes()),
            moved.col(slopes())};
}

}  // namespace crawford::reference
