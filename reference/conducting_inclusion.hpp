/// A disc that conducts in a matrix that conducts otherwise.
#pragma once

#include "reference/fade.hpp"
#include "reference/material.hpp"

namespace crawford::reference {

/// A disc of one conductor about the origin, in another.
struct DiscInHeat {
    double inner_conductivity = missing;  ///< kappa of the disc [W/(m K)]
    double outer_conductivity = missing;
    double radius = missing;       ///< [m]
    double temperature = missing;  ///< T0 [K], far away
    double gradient_x = missing;   ///< g [K/m], of the field that the disc disturbs
    double gradient_y = missing;
    double whole = missing;  ///< [m] the field is undiminished up to here, more than the radius
    double gone = missing;   ///< [m] and gone from here on
};

/// Steady heat past a disc, in closed form: T = T0 + chi(r) Phi,
///
///     Phi = 2 ko/(ki + ko) g.x  inside,   (1 - (ki - ko)/(ki + ko) R^2/r^2) g.x  outside,
///
/// which conducts the same heat on both sides of the circle. The interface lies where chi = 1 and
/// sees nothing of the fading, which a source in the matrix holds up:
/// q = -ko (2 grad chi.grad Phi + Phi lap chi).
class ConductingInclusion {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit ConductingInclusion(const DiscInHeat& disc);

    double temperature(double x, double y) const;  ///< [K]
    double source(double x, double y) const;       ///< q [W/m^3]

private:
    double undiminished(double x, double y) const;               ///< Phi [K]
    Eigen::Vector2d gradient_outside(double x, double y) const;  ///< of Phi [K/m]

    DiscInHeat disc_;
    Fade fade_;
};

}  // namespace crawford::reference
