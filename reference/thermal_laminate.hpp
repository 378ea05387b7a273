/// Layers side by side with heat across and along them.
#pragma once

#include "reference/material.hpp"

namespace crawford::reference {

/// A strip of one conductor, |x| < strip/2, between blocks of another; periodic in x.
struct TwoConductors {
    double inner_conductivity = missing;  ///< kappa of the strip [W/(m K)]
    double outer_conductivity = missing;
    double inner_capacity = missing;  ///< rho c of the strip [J/(m^3 K)]
    double outer_capacity = missing;
    double strip = missing;             ///< [m]
    double width = missing;             ///< period [m]
    double depth = missing;             ///< L [m]; the surface y = 0 is level
    double cold_temperature = missing;  ///< T0 [K], held at y = -L
    double rise = missing;              ///< A [K], the surface over the bottom at the interfaces
    double frequency = missing;         ///< omega [rad/s], 0 is steady
};

/// Heat that crosses two interfaces,
///
///     T = T0 + A (1 + y/L) [1 + (1 + sin(omega t)/2) G(x)],   kappa(x) G'(x) = F sin(2 pi
///     x/width),
///
/// with G = 0 on the interfaces, so that T and kappa dT/dx pass through them although kappa jumps;
/// F makes the largest |G| 1/2. With a source q and a flux through the surface this solves rho c
/// T_t = div(kappa grad T) + q. Neither of the two jumps: q because G vanishes where rho c jumps,
/// the flux because what does jump, kappa A/L, is one constant for each conductor and stands for
/// itself.
class ThermalLaminate {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit ThermalLaminate(const TwoConductors& solid);

    double temperature(double x, double y, double t) const;  ///< [K]
    double source(double x, double y, double t) const;       ///< q [W/m^3]

    double inner_flux() const;  ///< kappa A/L of the strip [W/m^2]
    double outer_flux() const;
    /// Heat conducted against x through the interface at x = strip/2, kappa dT/dx [W/m^2].
    double crossing_heat(double y, double t) const;
    /// What enters through the surface beside these, continuous in x [W/m^2].
    double further_flux(double x, double t) const;

private:
    struct Layer {
        double conductivity, capacity;
    };
    Layer layer(double x) const;
    double rises(double x) const;  ///< G
    double swing(double t) const;  ///< 1 + sin(omega t)/2
    double wave_number() const;    ///< 2 pi/width

    TwoConductors solid_;
    double strength_ = 0.0;  ///< F [W/(m^2 K)]
};

}  // namespace crawford::reference
