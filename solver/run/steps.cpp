#include "solver/run/steps.hpp"

#include <algorithm>
#include <cmath>

#include "base/work_done.hpp"
#include "solver/run/chosen_steps.hpp"

namespace crawford {

namespace {

/// Step n ends at n dt, so that times do not pile up rounding.
class EqualSteps : public Steps {
public:
    explicit EqualSteps(const Time& time) : length_(time.step), last_(crawford::last_step(time)) {}

    void advance(Simulation& simulation) override {
        take_step(simulation, length_ * double(simulation.state().step + 1), length_);
    }
    bool at_the_end(const State& state) const override { return state.step >= last_; }
    long last_step(const State&) const override { return last_; }

private:
    double length_;
    long last_;
};

}  // namespace

long last_step(const Time& time) {
    return std::lround(std::ceil(time.end / time.step - 1e-6));
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
