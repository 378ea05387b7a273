/// A ripple of the flat front as it dies.
#pragma once

#include "reference/front_modes.hpp"

namespace crawford::reference {

/// A ripple of the flat front of a burning half space as it dies (or, where pyrolysis frees heat,
/// grows): the slowest of its modes, exact up to the second order of its amplitude,
///
///     phi = -r t + a cos(k x) e^{sigma t},
///     T = T_0 + dT e^{r eta/alpha} + a T'(eta) cos(k x) e^{sigma t},   eta = y - phi <= 0.
class FrontRipple {
public:
    /// \param conditions as of steady_front()
    /// \param wave_number k [1/m]
    /// \throws std::invalid_argument naming the missing or out-of-range parameter, or where the
    /// slowest mode swings, so that no real one exists.
    FrontRipple(const SlabConditions& conditions, double wave_number);

    const SteadyFront& front() const { return front_; }
    double growth_rate() const;            ///< sigma [1/s]; below zero where it dies
    double temperature(double eta) const;  ///< T' [K/m]

private:
    SteadyFront front_;
    FrontMode mode_;
};

}  // namespace crawford::reference
