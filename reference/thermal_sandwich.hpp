/// Steady heat in the flat sandwich by finite elements of high degree.
#pragma once

#include <Eigen/Dense>

#include "reference/sandwich_geometry.hpp"

namespace crawford::reference {

/// What heats a sandwich that burns at one prescribed rate.
struct SandwichHeating {
    double inner_flux = missing;        ///< Q [W/m^2] into the strip
    double outer_flux = missing;        ///< Q [W/m^2] into the rest
    double burn_rate = missing;         ///< r_b [m/s], the same everywhere: the surface stays flat
    double cold_temperature = missing;  ///< T0 [K], held at y = -depth
};

/// The paper's: 200 and 160 cal/(s cm^2) into AP and binder, 0.45 cm/s, 300 K.
SandwichHeating paper_heating();

/// Steady heat in a sandwich with a flat surface and no mechanics,
///
///     rho c_p r_b dT/dy = div(kappa grad T),   kappa dT/dy = Q + q_s rho r_b at y = 0,
///
/// each material with its own rho, Q and q_s, by finite elements of high degree on the mesh of
/// ElasticSandwich. Where interface and surface meet T behaves as r ln r; away from there it
/// converges exponentially in the degree.
class ThermalSandwich {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    ThermalSandwich(const SandwichGeometry& geometry, const SandwichHeating& heating,
                    const SandwichElements& elements = {});

    /// T [K] at |x| <= half_width, -depth <= y <= 0.
    double temperature(double x, double y) const;
    /// Conducted heat -kappa grad T [W/m^2]; on the interface that of the strip.
    Eigen::Vector2d heat_flux(double x, double y) const;

private:
    void assemble_and_solve();
    double entering(const TensorSpace::Element& element) const;

    SandwichGeometry geometry_;
    SandwichHeating heating_;
    TensorSpace space_;
    Eigen::VectorXd temperature_;  // of each node [K]
};

}  // namespace crawford::reference
