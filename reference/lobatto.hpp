/// Nodes, weights and derivatives of Gauss-Lobatto-Legendre.
#pragma once

#include <Eigen/Dense>

namespace crawford::reference {

/// Lagrange polynomials of one degree through the Gauss-Lobatto points of [-1, 1], and their exact
/// integrals.
class LobattoBasis {
public:
    /// \throws std::invalid_argument unless degree >= 1.
    explicit LobattoBasis(int degree);

    int degree() const { return degree_; }
    const Eigen::VectorXd& points() const { return points_; }  ///< ascending, from -1 to 1

    Eigen::VectorXd values(double xi) const;       ///< phi_i(xi)
    Eigen::VectorXd derivatives(double xi) const;  ///< phi_i'(xi)

    const Eigen::MatrixXd& mass() const { return mass_; }            ///< integral of phi_i phi_j
    const Eigen::MatrixXd& stiffness() const { return stiffness_; }  ///< integral of phi_i' phi_j'
    const Eigen::MatrixXd& convection() const { return convection_; }  ///< integral of phi_i phi_j'

private:
    int degree_;
    Eigen::VectorXd points_;
    Eigen::MatrixXd mass_;
    Eigen::MatrixXd stiffness_;
    Eigen::MatrixXd convection_;
};

/// Points and weights of the Gauss-Legendre rule on [-1, 1], exact to degree 2 count - 1.
struct GaussRule {
    explicit GaussRule(int count);
    Eigen::VectorXd points;
    Eigen::VectorXd weights;
};

}  // namespace crawford::reference
