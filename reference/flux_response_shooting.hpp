/// How a burning slab that expands answers a flux that swings, by shooting.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "reference/slab.hpp"

namespace crawford::reference {

/// What swings at one depth, as complex amplitudes: T = T_b + a Re(T' e^{i w t}).
struct Fluctuation {
    std::complex<double> temperature;           ///< T' [K]
    std::complex<double> temperature_gradient;  ///< T'_y [K/m]
    std::complex<double> velocity;              ///< v' [m/s]
};

/// The slab under a flux that swings, Q (1 + a cos(w t)) with a << 1, with what expansion does to
/// it: the equations of the model in one dimension, linearised about the steady slab and solved by
/// shooting (Boost.Odeint).
///
/// In the frame of the surface, D/Dt = d/dt + (r + v) d/dy. Equilibrium keeps sigma_22 = -p_c, so 0
/// = P v_y - beta DT/Dt, and the heat that expansion takes joins the capacity:
///
///     H(T) DT/Dt = kappa T_yy,   v_y = theta DT/Dt,   H = rho c_p + s beta theta T
///
/// with theta = beta/P and the s of SlabEnergy, which tells c_p from c_v. With m = r + v, what
/// comes up, and m_b = r e^{theta D}:
///
///     kappa T'_yy = H [i w T' + m_b T'_y + m' T_b,y] + H_T m_b T_b,y T',   m'_y = theta [...]
///     T'(-L) = 0, m'(-L) = r';   kappa T'_y(0) = Q + q_s rho r', r' = r s T'(0)
///
/// Three solutions span these, each found where it is stable: the steady profile moved by the
/// surface, T' = -T_b,y/(i w), m' = 1 - m_b,y/(i w), is known; one that fades downwards is shot up
/// from the bottom; one that fades upwards is shot down, and is wanted only where there is a
/// bottom.
class FluxResponseShooting {
public:
    /// \param conditions of a slab of SlabModel::thermal or eulerian; at a prescribed rate r' = 0
    /// \param frequency f [Hz], w = 2 pi f
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    FluxResponseShooting(const SlabConditions& conditions, double frequency);

    const Slab& slab() const { return slab_; }
    std::complex<double> burn_rate() const;            ///< (r'/r)/a
    std::complex<double> surface_temperature() const;  ///< T'(0) [K]

    /// At the depths y [m] <= 0, in any order.
    /// \throws std::invalid_argument for a point above the surface or below the bottom.
    std::vector<Fluctuation> fluctuations(std::span<const double> y) const;

private:
    Slab slab_;
    double frequency_;
    double sensitivity_;  // d ln r/dT [1/K]
    std::complex<double> surface_temperature_;
    std::array<std::complex<double>, 3> share_{};  // of moved, fading downwards, fading upwards
};

}  // namespace crawford::reference
