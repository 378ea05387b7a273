/// The limit of values on three grids, with its uncertainty.
#pragma once

#include <span>

namespace crawford::reports {

/// What the grid sequence says about h -> 0.
struct Extrapolation {
    double value;        ///< Richardson's estimate of the limit
    double uncertainty;  ///< Grid convergence index: half-width about the value on the finest grid,
                         ///< same unit
    double observed;     ///< Order observed on the three finest grids, from successive differences
    double order;        ///< Order used: the observed one clamped to [0.5, formal]
    double safety;       ///< 1.25 if the observed order is within 10 % of formal and the values go
                         ///< one way, else 3
};

/// Order p with (u1 - u2)/(u2 - u3) = (h1^p - h2^p)/(h2^p - h3^p), signs aside, from three grids,
/// coarse to fine; within [-12, 12], beyond any scheme. NaN if a value is.
double observed_order(std::span<const double, 3> h, std::span<const double, 3> values);

/// Richardson extrapolation and grid convergence index (Roache) from the three finest grids; any
/// refinement ratios. Applies to any number that converges: a temperature, or an error, whose limit
/// then shows what does not vanish. All NaN if a value is NaN.
/// \throws std::invalid_argument below three grids or if h does not fall.
Extrapolation extrapolate(std::span<const double> h, std::span<const double> values,
                          double formal_order);

}  // namespace crawford::reports
