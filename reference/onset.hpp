/// A front that swings by the heat of its own pyrolysis.
#pragma once

#include "reference/front_modes.hpp"

namespace crawford::reference {

/// Whether a flat front whose pyrolysis frees heat burns steadily, or swings ever more. Without
/// ripples (K = 0) front_modes() is left with lambda^2 - z Theta lambda + z = 0 beside the root S =
/// 0, so that
///
///     lambda = w/2 + i sqrt(z - w^2/4),   S = (w - 1) lambda - z,   w = z Theta,
///
/// which grows from Re S = 0, w = (1 + sqrt(1 + 8 z))/2, on.
class SwingingFront {
public:
    /// \param conditions as of steady_front(), with q_s > 0
    /// \throws std::invalid_argument naming the missing or out-of-range parameter, or where the
    /// front does not swing (w <= 0 or w^2 >= 4 z).
    explicit SwingingFront(const SlabConditions& conditions);

    const SteadyFront& front() const { return front_; }
    /// sigma [1/s]: growth, and the angular frequency of the swing, above zero.
    std::complex<double> growth_rate() const { return front_.rate_unit() * mode_.growth; }
    /// T' [K/m] at eta [m] below the front: with the front too high by a Re e^{sigma t}, T is too
    /// high by a Re(T' e^{sigma t}).
    std::complex<double> temperature(double eta) const { return mode_.temperature(front_, eta); }

private:
    SteadyFront front_;
    FrontMode mode_;
};

/// q_s [J/kg] from which on the front of this half space swings ever more; its own q_s is not read.
/// \throws std::invalid_argument as SwingingFront
double heat_of_reaction_at_onset(SlabConditions conditions);

}  // namespace crawford::reference
