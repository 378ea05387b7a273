/// How a rigid burning slab answers a flux that swings.
#pragma once

#include <complex>

#include "reference/slab.hpp"

namespace crawford::reference {

/// A rigid slab under a flux that swings, Q (1 + a cos(w t)) with a << 1: what answers with the same
/// frequency, in closed form. Solid below y = 0, the surface; T = T_b(y) + a Re(T'(y) e^{i w t}).
///
/// Linearised about the steady slab of depth L, with alpha = kappa/(rho c), s = d ln r/dT = Ea/(R
/// T_s^2), A = T_b'(0) alpha/r (dT in a half space) and r' = r s T'(0):
///
///     i w T' + r T'_y + r' T_b,y = alpha T'_yy,   kappa T'_y(0) = Q + q_s rho r',   T'(-L) = 0
///     T' = C_1 e^{l_1 r y/alpha} + C_2 e^{l_2 r (y + L)/alpha} - (r'/(i w)) (A r/alpha) e^{r y/alpha}
///     l_1,2 = (1 +- sqrt(1 + 4 i w alpha/r^2))/2
///
/// The last part is the steady profile moved by the surface's own swing, -r'/(i w).
class FluxResponse {
public:
    /// \param conditions of a slab of SlabModel::thermal; at a prescribed rate r' = 0
    /// \param frequency f [Hz], w = 2 pi f
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    FluxResponse(const SlabConditions& conditions, double frequency);

    const Slab& slab() const { return slab_; }
    /// (r'/r)/a: by how much more the rate swings than the flux, and how much earlier.
    std::complex<double> burn_rate() const { return sensitivity_ * surface_temperature_; }
    /// T'(0) [K]
    std::complex<double> surface_temperature() const { return surface_temperature_; }
    /// T'(y) [K], for a given depth below the moving surface.
    /// \throws std::invalid_argument for a point above the surface or below the bottom.
    std::complex<double> temperature(double y) const;

private:
    std::complex<double> rising(double y) const;   // e^{l_1 r y/alpha}
    std::complex<double> sinking(double y) const;  // e^{l_2 r (y + L)/alpha}
    std::complex<double> moved(double y) const;    // the profile moved, for T'(0) = 1 K

    Slab slab_;
    double sensitivity_;                      // s [1/K]
    double wave_number_;                      // r/alpha [1/m]
    double swing_;                            // A [K]
    std::complex<double> angular_frequency_;  // i w [1/s]
    std::complex<double> root_;               // sqrt(1 + 4 i w alpha/r^2)
    std::complex<double> surface_temperature_, from_surface_, from_bottom_;
};

/// d ln r_b/dT [1/K] at a surface temperature [K]; 0 where the rate is prescribed.
double burn_rate_sensitivity(const SlabConditions& conditions, double surface_temperature);

}  // namespace crawford::reference
