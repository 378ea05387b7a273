/// A layer of heat that travels with the front.
#pragma once

#include "reference/material.hpp"

namespace crawford::reference {

/// A rigid half space whose surface sinks at a constant rate under a constant flux.
struct BurningHalfSpace {
    double conductivity = missing;      ///< kappa [W/(m K)]
    double capacity = missing;          ///< rho c [J/(m^3 K)]
    double regression_rate = missing;   ///< r [m/s]
    double flux = missing;              ///< Q [W/m^2]
    double cold_temperature = missing;  ///< T0 [K]
};

/// Its thermal boundary layer at eta = y - phi <= 0, in the frame of the surface:
///
///     rho c (T_t + r T_eta) = kappa T_etaeta,   kappa T_eta = Q at eta = 0.
class TravellingLayer {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit TravellingLayer(const BurningHalfSpace& solid);

    /// Steady T [K] of a solid that is held at T0 in the moving plane eta = -depth:
    /// T0 + Q/(r rho c) (exp(eta/l) - exp(-depth/l)), l = kappa/(r rho c).
    double steady(double eta, double depth) const;

    /// T [K] at a time t > 0 after the flux has met a solid at T0 throughout. With a, b = (-eta +-
    /// r t)/(2 sqrt(D t)), D = kappa/(rho c):
    ///     T0 + Q/(2 kappa) [2 sqrt(D t) ierfc(a) + l (exp(eta/l) erfc(b) - erfc(a))].
    /// The flux -kappa T_eta of that is Ogata and Banks' solution of the same equation, and this is
    /// its integral from -infinity.
    double heating(double eta, double t) const;

    double thickness() const;  ///< l [m]

private:
    BurningHalfSpace solid_;
};

}  // namespace crawford::reference
