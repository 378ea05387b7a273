/// How a run is divided into steps: evenly, or as the error of each allows.
#pragma once

#include <memory>
#include <optional>

#include "solver/files/step_choice.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

class Steps {
public:
    virtual ~Steps() = default;

    /// Takes the simulation one step further, which may take trials.
    /// \throws NumericalFailure if no step can be taken; the state is then the last good one.
    virtual void advance(Simulation& simulation) = 0;

    /// Whether time.end is reached.
    virtual bool at_the_end(const State& state) const = 0;

    /// What the next step's choice rests on; nothing where steps are equal.
    virtual std::optional<StepChoice> choice() const { return {}; }
    /// Goes on from there, bit for bit.
    virtual void resume(const StepChoice& /*choice*/) {}

    /// The number that the last step will probably have, for who shows progress.
    virtual long last_step(const State& state) const = 0;
};

/// As the scene asks for it. The simulation must outlive it.
std::unique_ptr<Steps> steps_of(const Simulation& simulation);

/// The last step of a run of equal steps. An end that is no multiple of the step is passed by the
/// least that covers it.
long last_step(const Time& time);

/// How many steps of this length it takes to cover a span [s]; 0 where none is left.
long steps_over(double span, double length);

/// One step of the simulation, booked as work done.
void take_step(Simulation& simulation, double end, double length);

}  // namespace crawford
