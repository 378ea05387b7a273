#include "solver/run/loop.hpp"

namespace crawford {

Stop after_steps(const Simulation& simulation, long count) {
    return [last = simulation.state().step + count](const Simulation& now) {
        return now.state().step >= last;
    };
}

void run_until(Simulation& simulation, Steps& steps, const Stop& stop,
               const std::vector<Observer>& observers) {
    while (!stop(simulation)) {
        const double before = simulation.state().time;
        steps.advance(simulation);
        for (const Observer& observer : observers) observer(simulation, before);
    }
}

void run_until(Simulation& simulation, const Stop& stop, const std::vector<Observer>& observers) {
    run_until(simulation, *steps_of(simulation), stop, observers);
}

void run_to_end(Simulation& simulation, const std::vector<Observer>& observers) {
    const auto steps = steps_of(simulation);
    const Stop at_the_end = [&](const Simulation& now) { return steps->at_the_end(now.state()); };
    run_until(simulation, *steps, at_the_end, observers);
}

void run_steps(Simulation& simulation, long count, const std::vector<Observer>& observers) {
    run_until(simulation, after_steps(simulation, count), observers);
}

}  // namespace crawford
