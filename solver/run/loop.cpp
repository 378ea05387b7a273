#include "solver/run/loop.hpp"

#include <algorithm>
#include <cmath>

#include "base/work_done.hpp"

namespace crawford {

long last_step(const Time& time) {
    return std::lround(std::ceil(time.end / time.step - 1e-6));
}

namespace {

Stop at_step(long last) {
    return [last](const Simulation& simulation) { return simulation.state().step >= last; };
}

void book_step(const Simulation& simulation) {
    WorkDone& done = work_of_this_thread();
    const Grid& grid = simulation.grid();
    ++done.steps;
    done.cells = std::max(done.cells, long(grid.cell_columns()) * grid.rows());
    done.solver_iterations += simulation.solver_iterations();
}

/// The time at which the next step ends [s].
double next_time(const Simulation& simulation) {
    return simulation.scene().time.step * double(simulation.state().step + 1);
}

}  // namespace

Stop at_the_end(const Simulation& simulation) {
    return at_step(last_step(simulation.scene().time));
}

Stop after_steps(const Simulation& simulation, long count) {
    return at_step(simulation.state().step + count);
}

void run_until(Simulation& simulation, const Stop& stop, const std::vector<Observer>& observers) {
    while (!stop(simulation)) {
        const double before = simulation.state().time;
        simulation.step(next_time(simulation));
        book_step(simulation);
        for (const Observer& observer : observers) observer(simulation, before);
    }
}

void run_to_end(Simulation& simulation, const std::vector<Observer>& observers) {
    run_until(simulation, at_the_end(simulation), observers);
}

void run_steps(Simulation& simulation, long count, const std::vector<Observer>& observers) {
    run_until(simulation, after_steps(simulation, count), observers);
}

}  // namespace crawford
