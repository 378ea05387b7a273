/// A whole burning solid, manufactured: surface, temperature, motion, stress and reference map are
/// smooth functions chosen at will, and the sources are what the equations lack to have them for a
/// solution. Every term of the model is at work and of comparable size: a sloped surface that
/// regresses and travels, heat, large rotation, strain of a few per cent, stress of its own.
///
/// Two couplings are met by construction and need no source:
///
///     phi_t = -r_b sqrt(1 + phi_x^2)   gives r_b, and r_b = A exp(-Ea/(R T_s)) then T_s
///     D(xi)/Dt = 0                     gives v = -(grad xi)^-1 xi_t from the map xi
///
/// The bottom of the window, y = phi - depth, is held: T = T_0, v = 0, xi = (x, y), and the stress
/// has no gradient normal to it. Derivatives are taken by automatic differentiation.
#pragma once

#include <Eigen/Core>
#include <array>

#include "reference/material.hpp"
#include "reference/plane_strain_stress.hpp"

namespace crawford::reference {

struct BurningParameters {
    Material material;
    double width = missing;               ///< period in x [m]
    double depth = missing;               ///< of the window below the surface [m]
    double regression_rate = missing;     ///< of the mean surface [m/s]
    double wave_height = missing;         ///< of the surface [m]
    double wave_frequency = missing;      ///< at which it travels [1/s]
    double bottom_temperature = missing;  ///< T_0 [K]
    double displacement = missing;        ///< size of xi - (x, y) [m]
    double motion_frequency = missing;    ///< of the motion [1/s]
    double stress = missing;              ///< size of the stress [Pa]
    double gas_pressure = missing;        ///< p_c, of which the traction is the remainder [Pa]
    double gas_flux = missing;            ///< Q_g, of which the heat flux is the remainder [W/m^2]
};

class ManufacturedBurning {
public:
    /// beta = 3 alpha K, c = c_p.
    /// \throws std::invalid_argument naming the parameter that is missing or out of range: lengths,
    /// rates and moduli must be positive, and the surface must regress everywhere.
    explicit ManufacturedBurning(const BurningParameters& parameters);

    // The solution, at (x [m], y [m], t [s]).
    double surface(double x, double t) const;                                  ///< phi [m]
    double temperature(double x, double y, double t) const;                    ///< T [K]
    double temperature_rate(double x, double y, double t) const;               ///< DT/Dt [K/s]
    Eigen::Vector2d velocity(double x, double y, double t) const;              ///< v [m/s]
    Eigen::Matrix2d velocity_gradient(double x, double y, double t) const;     ///< dv_i/dx_j [1/s]
    PlaneStrainStress stress(double x, double y, double t) const;              ///< sigma
    Eigen::Vector2d shift(double x, double y, double t) const;                 ///< xi - (x, y) [m]
    Eigen::Matrix2d deformation_gradient(double x, double y, double t) const;  ///< (grad xi)^-1

    // What the equations lack.
    double heat_source(double x, double y, double t) const;               ///< q [W/m^3]
    PlaneStrainStress stress_source(double x, double y, double t) const;  ///< S [Pa/s]
    Eigen::Vector2d body_force(double x, double y, double t) const;       ///< b [N/m^3]
    double heat_flux(double x, double t) const;          ///< beside Q_g + q_s rho r_b [W/m^2]
    Eigen::Vector2d traction(double x, double t) const;  ///< beside -p_c n [Pa]

private:
    struct Motion;
    Motion motion(double x, double y, double t) const;

    BurningParameters p_;
};

}  // namespace crawford::reference
