#pragma once

#include <Eigen/Dense>
#include <memory>
#include <string>

#include "reference/sloped_heat.hpp"

namespace crawford::reference {

/// How finely a burning sandwich is resolved: polynomial degree, and geometric layers towards the
/// interface and below the surface, whose last is ratio^layers of the strip.
struct FrontElements {
    int degree = 6;
    int layers = 7;
    double ratio = 0.3;
};

/// The steadily burning rigid sandwich as a free-boundary problem: the surface y = phi(x) and its
/// speed V are found together with the temperature below (\see SlopedHeat),
///
///     r(T_s) sqrt(1 + phi_x^2) = V,   r = A exp(-Ea/(R T_s)),
///
/// each material with its own r. This is the viscosity solution: the outer material burns faster
/// at the interface, leads there with a level front, r_outer(T_s) = V, and the surface rises
/// from there to both sides. Only where the strip is the slower at the interface, and no part of
/// the surface alone would be faster than V, is that the solution.
///
/// Newton's method on slopes and V. Where surface and interface meet T is singular and the front
/// has a notch; the mesh is graded into it.
class BurningSandwichFront {
public:
    /// \throws std::invalid_argument naming the parameter that is missing or out of range, or
    /// where the strip is not the slower at the interface.
    /// \throws NumericalFailure if no solution of this kind is found.
    BurningSandwichFront(const SandwichGeometry& geometry, const SandwichFlame& flame,
                         const FrontElements& elements = {});

    double regression_rate() const { return rate_; }        ///< V [m/s], the speed of the front
    double regression_rate_uncertainty() const { return uncertainty_; }  ///< [m/s]
    double mean_burn_rate() const;         ///< r averaged over the length of the surface [m/s]
    double interface_temperature() const;  ///< T_s [K] at the interface
    double notch_depth() const { return -height(geometry_.strip); }  ///< interface below the side [m]

    /// phi [m] at |x| <= half_width, 0 at the sides x = +-half_width.
    double height(double x) const;
    double surface_slope(double x) const;        ///< phi_x; on the interface that of the strip
    double surface_temperature(double x) const;  ///< T_s [K]
    /// T [K] at |x| <= half_width, phi(x) - depth <= y <= phi(x).
    double temperature(double x, double y) const;

    /// Heat through the surface [W/m] of half a period, per unit thickness: what the flames give
    /// and pyrolysis takes.
    double heat_in() const;
    /// What the solid that comes up at V carries out through the surface above T0 [W/m].
    double enthalpy_out() const;

private:
    double newton();

    SandwichGeometry geometry_;
    SandwichFlame flame_;
    SlopedHeat heat_;
    Eigen::VectorXd slope_;
    double rate_ = missing;
    double uncertainty_ = missing;
    SlopedHeat::Response response_;
};

}  // namespace crawford::reference
