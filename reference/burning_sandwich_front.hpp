/// The steadily burning rigid sandwich as a free-boundary problem.
#pragma once

#include "reference/steady_front.hpp"
#include "reference/surface_curve.hpp"

namespace crawford::reference {

/// The paper's flame: 200 and 160 cal/(s cm^2) into AP and binder, 300 K.
SandwichFlame paper_flame();

/// Resolution with which V of the paper's sandwich stands to 3e-6 of itself.
inline constexpr SandwichElements front_elements{.degree = 6, .layers = 8, .ratio = 0.3};

/// The steadily burning rigid sandwich as a free-boundary problem: surface y = phi(x) and speed V
/// are found together with the temperature below (\see SlopedHeat) from
///
///     r(T_s) sqrt(1 + phi_x^2) = V,   r = A exp(-Ea/(R T_s)),
///
/// each material with its own r. This is the viscosity solution where the outer material is the
/// faster one: at the interface it leads with a level front, r_outer(T_s) = V, and the surface
/// rises from there to both sides, to level or kinked crests on the planes of symmetry.
///
/// Where surface and interface meet the front has a notch and T is singular; the mesh is graded
/// into it.
class BurningSandwichFront {
public:
    /// Moduli and thermal expansion are not read.
    /// \throws std::invalid_argument naming the parameter that is missing or out of range, or if
    /// the strip is the faster material.
    /// \throws NumericalFailure if no front is found that rises from the interface.
    BurningSandwichFront(const SandwichGeometry& geometry, const SandwichFlame& flame,
                         const SandwichElements& elements = front_elements);

    double regression_rate() const { return front_.rate; }  ///< V [m/s], what a strand burner sees
    /// How far V moves with two degrees and two layers less [m/s].
    double regression_rate_uncertainty() const { return uncertainty_; }
    double mean_burn_rate() const;         ///< r averaged over the arc [m/s]
    double interface_temperature() const;  ///< T_s [K] at the interface
    double notch_depth() const;            ///< of the interface below the sides [m]

    /// phi [m] at |x| <= half_width, 0 at the sides x = +-half_width.
    /// \throws std::invalid_argument outside, as all that follow.
    double height(double x) const;
    double slope(double x) const;                ///< phi_x; on the interface that of the strip
    double surface_temperature(double x) const;  ///< T_s [K]
    /// T [K] at phi(x) - depth <= y <= phi(x).
    double temperature(double x, double y) const;

    /// Heat through the half surface [W/m]: what the flame gives and pyrolysis takes.
    double heat_in() const;
    /// What the solid takes out through the half surface above T0 [W/m].
    double enthalpy_out() const;

private:
    void require_within(double x) const;

    SandwichGeometry geometry_;
    SandwichFlame flame_;
    TensorSpace space_;
    SteadyFront front_;
    SurfaceCurve curve_;
    double uncertainty_ = 0.0;  // [m/s]
};

}  // namespace crawford::reference
