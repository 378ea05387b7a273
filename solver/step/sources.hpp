/// Sources that drive the solver to a manufactured solution; none in a physical scene.
#pragma once

#include <functional>

#include "solver/mesh/lattice.hpp"
#include "solver/stress/stress_field.hpp"

namespace crawford {

/// Functions of the true place and time (x [m], y [m], t [s]), the last two of places on the
/// surface. An empty one is zero and costs nothing.
struct Sources {
    template <class Value>
    using Function = std::function<Value(double x, double y, double t)>;

    Function<double> heat = {};         ///< q [W/m^3]
    Function<PlaneStress> stress = {};  ///< S [Pa/s]
    Function<Vector> body_force = {};   ///< b [N/m^3]
    Function<double> heat_flux = {};    ///< into the solid, beside the burning law's [W/m^2]
    Function<Vector> traction = {};     ///< sigma.n beside the gas pressure's [Pa]
};

}  // namespace crawford
