/// What swings and what grows, read from a series of numbers at equal steps.
#pragma once

#include <complex>
#include <span>

namespace crawford {

/// The part of a series that swings with angular frequency w [1/s]: c, where x(t) = Re(c e^{i w t})
/// fits best, beside twice the frequency, which comes with the amplitude, and a cubic in t, for what
/// drifts meanwhile.
/// \param start time of the first value [s]
std::complex<double> swing(std::span<const double> series, double start, double step, double w);

/// sigma [1/s], where x(t) = Re(c e^{sigma t}) fits best, by Prony's method: such a series obeys x(t
/// + h) = 2 e^{Re sigma h} cos(Im sigma h) x(t) - e^{2 Re sigma h} x(t - h). Im sigma > 0.
/// \param lag values between x(t) and x(t + h), best an eighth of a period
std::complex<double> swinging_growth(std::span<const double> series, double step, int lag);

/// sigma [1/s], where ln x(t) = ln c + sigma t fits best; all values above zero.
double plain_growth(std::span<const double> series, double step);

}  // namespace crawford
