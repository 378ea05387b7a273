#include "solver/run/steps.hpp"

#include <algorithm>
#include <cmath>

#include "base/work_done.hpp"
#include "solver/run/chosen_steps.hpp"

namespace crawford {

namespace {

// Of a step: times are sums of steps.
constexpr double grace = 1e-6;

/// Step n ends at n dt, so that times do not pile up rounding. After a restart with another dt it ends
/// dt after the last: what the next time is depends on the state alone.
class EqualSteps : public Steps {
public:
    explicit EqualSteps(const Time& time) : length_(time.step), end_(time.end) {}

    void advance(Simulation& simulation) override {
        const State& now = simulation.state();
        const bool counted = std::abs(now.time / length_ - double(now.step)) < grace;
        take_step(simulation, counted ? length_ * double(now.step + 1) : now.time + length_,
                  length_);
    }
    bool at_the_end(const State& state) const override { return steps_left(state) == 0; }
    long last_step(const State& state) const override { return state.step + steps_left(state); }

private:
    long steps_left(const State& state) const { return steps_over(end_ - state.time, length_); }

    double length_, end_;
};

}  // namespace

long last_step(const Time& time) {
    return steps_over(time.end, time.step);
}

long steps_over(double span, double length) {
    return std::max(std::lround(std::ceil(span / length - grace)), 0L);
}

void take_step(Simulation& simulation, double end, double length) {
    WorkDone& done = work_of_this_thread();
    const Grid& grid = simulation.grid();
    ++done.steps;
    done.cells = std::max(done.cells, long(grid.cell_columns()) * grid.rows());
    simulation.step(end, length);
    done.solver_iterations += simulation.solver_iterations();
}

std::unique_ptr<Steps> steps_of(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    if (scene.time.accuracy) return std::make_unique<ChosenSteps>(scene, simulation.grid());
    return std::make_unique<EqualSteps>(scene.time);
}

}  // namespace crawford
