/// The disc whose field fades out before the sides of a window.
#pragma once

#include "reference/circular_inclusion.hpp"
#include "reference/fade.hpp"

namespace crawford::reference {

/// A circular inclusion whose displacement fades to zero inside a finite window:  w = chi(r) u(x,
/// y).
///
/// chi is 1 up to the radius `whole`, 0 from the radius `gone` on, and a polynomial with three
/// continuous derivatives between them. The interface lies where chi = 1, so its conditions are
/// those of the exact inclusion, untouched; beyond `gone` there is neither displacement nor
/// traction, whatever holds the window. What drives it in the matrix is b = -div(C:grad w),
///
///     b = -[ sigma(u).grad chi + lambda (grad(u)^T.grad chi + H.u)
///            + mu (grad(u).grad chi + u lap chi + H.u + grad chi div u) ],   H = grad grad chi,
///
/// since div sigma(u) = 0.
class FadedInclusion {
public:
    /// \throws std::invalid_argument naming the parameter, unless radius < whole < gone.
    FadedInclusion(const CircularInclusion& inclusion, double whole, double gone);

    Eigen::Vector2d displacement(double x, double y) const;  ///< w [m]
    PlaneStrainStress stress(double x, double y) const;      ///< C:grad w [Pa]
    Eigen::Vector2d body_force(double x, double y) const;    ///< b [N/m^3]

private:
    CircularInclusion inclusion_;
    Fade fade_;
};

}  // namespace crawford::reference
