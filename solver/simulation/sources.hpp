/// Sources that drive the solver to a manufactured solution; none in a physical scene.
#pragma once

#include <functional>

#include "solver/fields/lattice.hpp"
#include "solver/stress/stress_field.hpp"

namespace crawford {

/// Functions of the true place and time (x [m], y [m], t [s]).
/// An empty one is zero and costs nothing.
struct Sources {
    std::function<double(double, double, double)> heat = {};         ///< q [W/m^3]
    std::function<PlaneStress(double, double, double)> stress = {};  ///< S [Pa/s]
    std::function<Vector(double, double, double)> body_force = {};   ///< b [N/m^3]
};

}  // namespace crawford
