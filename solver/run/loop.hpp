/// The time loop: the only one that advances a simulation.
#pragma once

#include <functional>
#include <vector>

#include "solver/run/steps.hpp"

namespace crawford {

/// Whether the run stops; asked before each step.
using Stop = std::function<bool(const Simulation&)>;

/// Told after each step, with the time at which the step began [s]. It may make the simulation
/// forget its factorisation, as a checkpoint does.
using Observer = std::function<void(Simulation&, double before)>;

/// Stops `count` steps from where the simulation now stands.
Stop after_steps(const Simulation& simulation, long count);

/// Steps until `stop`, and tells all observers of each step, in their order.
/// \throws NumericalFailure if a step fails: no observer is told of it, and the state is the last
/// good one.
void run_until(Simulation& simulation, Steps& steps, const Stop& stop,
               const std::vector<Observer>& observers = {});
void run_until(Simulation& simulation, const Stop& stop,
               const std::vector<Observer>& observers = {});

/// Runs to time.end.
void run_to_end(Simulation& simulation, const std::vector<Observer>& observers = {});

/// Runs `count` steps.
void run_steps(Simulation& simulation, long count, const std::vector<Observer>& observers = {});

}  // namespace crawford
