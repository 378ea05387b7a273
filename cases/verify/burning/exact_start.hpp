/// A burn that starts from an exact state of its front instead of a cold block.
#pragma once

#include <functional>

#include "solver/step/simulation.hpp"

namespace crawford {

/// The exact solution, in eta = y - phi <= 0.
struct ExactFront {
    std::function<double(double x, double t)> surface;                  ///< phi [m]
    std::function<double(double x, double eta, double t)> temperature;  ///< T [K]
    /// What more the scene has: velocity, stress, DT/Dt.
    std::function<void(State& state, const Grid& grid, double t)> mechanics = {};
};

/// Puts the simulation at t = 0 of the exact solution, and where its scheme looks back, the state
/// before at -dt: no step is then one of another order.
void start_exactly(Simulation& simulation, const ExactFront& exact);

}  // namespace crawford
