/// Steady heat below a sloped surface that recedes as a whole.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reference/sandwich_geometry.hpp"

namespace crawford::reference {

/// What a steadily burning sandwich takes through its surface, and what it starts from.
struct SandwichFlame {
    double inner_flux = missing;        ///< Q [W/m^2] of true surface, into the strip
    double outer_flux = missing;        ///< Q [W/m^2] into the rest
    double cold_temperature = missing;  ///< T0 [K], held at the bottom
};

/// Steady heat in the half sandwich below a surface y = phi(x) of given slope that recedes as a
/// whole at V, seen from the surface,
///
///     rho c_p V dT/dy = div(kappa grad T),   kappa n.grad T = Q + q_s rho V/sqrt(1 + phi_x^2),
///     T = T0 at y = phi - depth,
///
/// by finite elements of high degree in x and eta = y - phi(x). What a piece of front burns along
/// its normal, V/sqrt(1 + phi_x^2), times its length is V dx: given slope and V the problem is
/// linear in T, and has an exact derivative by either.
///
/// Slopes are given at the surface nodes from left to right, the interface counted twice: as the
/// end of the strip, then as the beginning of the rest. Between nodes they are polynomials.
class SlopedHeat {
public:
    /// \param space in x and eta, its elements on one side of the interface; \see in_strip
    SlopedHeat(const SandwichGeometry& geometry, const SandwichFlame& flame, TensorSpace space);

    const TensorSpace& space() const { return space_; }
    int slopes() const { return space_.columns() + 1; }
    int interface_column() const { return interface_column_; }  ///< of the surface nodes
    Eigen::VectorXd surface_places() const;                     ///< x [m] of the surface nodes

    struct Response {
        Eigen::VectorXd temperature;  ///< T [K] of each node
        Eigen::VectorXd surface;      ///< T_s [K] of each surface node
        Eigen::MatrixXd by_slope;     ///< dT_s/dphi_x [K], surface nodes x slopes
        Eigen::VectorXd by_rate;      ///< dT_s/dV [K s/m]
    };
    /// \param slope phi_x at slopes() places
    /// \param rate V [m/s]
    /// \throws std::runtime_error if the matrix is singular.
    Response respond(const Eigen::VectorXd& slope, double rate) const;

private:
    struct Column;  // of elements: its material, and its slopes at the points of the rule

    Column column(int index, const Eigen::VectorXd& slope) const;
    Eigen::MatrixXd matrix(const Column& column, double height, double rate) const;
    Eigen::MatrixXd convection(const Column& column) const;
    Eigen::VectorXd entering(const Column& column, double rate) const;
    Eigen::MatrixXd force_of_slope(const Column& column, double height,
                                   const Eigen::MatrixXd& temperature) const;
    Eigen::MatrixXd entering_of_slope(const Column& column) const;
    bool is_top(int element) const { return element >= space_.top_element(0); }

    SandwichGeometry geometry_;
    SandwichFlame flame_;
    TensorSpace space_;
    int interface_column_ = 0;
    GaussRule rule_;
    Eigen::MatrixXd value_, derivative_;  // of the basis, points of the rule x local nodes
};

}  // namespace crawford::reference
