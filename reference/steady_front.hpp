/// Surface and speed of a front that recedes as a whole, by Newton's method.
#pragma once

#include "reference/sloped_heat.hpp"

namespace crawford::reference {

/// Temperature [K] at which a material keeps pace with a front of speed V [m/s] where the front
/// has a slope: r(T) sqrt(1 + slope^2) = V, r = A exp(-Ea/(R T)).
double pace_temperature(const Material& material, double slope, double rate);

/// Slope, speed and temperature of the front that a sandwich burns with.
struct SteadyFront {
    Eigen::VectorXd slope;        ///< at the places of SlopedHeat
    double rate;                  ///< V [m/s]
    Eigen::VectorXd temperature;  ///< T [K] of each node
};

/// Finds slopes and V such that each place of the surface keeps pace, level in the outer material
/// at the interface, by Newton's method. Unknown and equation belong to one place each; that of
/// the level one is V.
/// \throws std::invalid_argument if the strip is the faster material.
/// \throws NumericalFailure if it does not converge, or to a front that falls from the interface.
SteadyFront find_steady_front(const SandwichGeometry& geometry, const SandwichFlame& flame,
                              const SlopedHeat& heat);

}  // namespace crawford::reference
