#include "cases/verify/burning/exact_start.hpp"

namespace crawford {

namespace {

State state_at(const Simulation& simulation, const ExactFront& exact, double t) {
    const Grid& grid = simulation.grid();
    State state = simulation.state();
    state.time = t;
    for (int i = 0; i < grid.node_columns(); ++i) {
        state.surface[size_t(i)] = exact.surface(grid.x(i), t);
        for (int j = 0; j <= grid.rows(); ++j)
            state.temperature(i, j) = exact.temperature(grid.x(i), grid.eta(j), t);
    }
    if (exact.mechanics) exact.mechanics(state, grid, t);
    return state;
}

}  // namespace

void start_exactly(Simulation& simulation, const ExactFront& exact) {
    State start = state_at(simulation, exact, 0.0);
    const Time& time = simulation.scene().time;
    if (time.scheme == Stepping::bdf2)
        start.previous = std::make_shared<const State>(state_at(simulation, exact, -time.step));
    simulation.restore(std::move(start));
}

}  // namespace crawford
