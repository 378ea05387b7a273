#include "solver/files/snapshot.hpp"

#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

NodeVectors mapped(const NodeVectors& position, NodeVectors shift) {
    for (size_t node = 0; node < shift.values().size(); ++node)
        shift.values()[node] += position.values()[node];
    return shift;
}

Lattice<PlaneStress> mean_stress(const StressField& stress) {
    Lattice<PlaneStress> mean(stress.pressure.columns(), stress.pressure.rows());
    for (int i = 0; i < mean.columns(); ++i)
        for (int j = 0; j < mean.rows(); ++j) mean(i, j) = stress.mean(i, j);
    return mean;
}

}  // namespace

NodeVectors positions(const Grid& grid, const SurfaceField& surface) {
    NodeVectors position(grid.cell_columns() + 1, grid.rows() + 1);
    for (int i = 0; i < position.columns(); ++i)
        for (int j = 0; j < position.rows(); ++j)
            position(i, j) = {grid.x(i), grid.eta(j) + surface[size_t(i) % surface.size()]};
    return position;
}

Snapshot collect_snapshot(const Grid& grid, const State& state) {
    Snapshot snapshot;
    snapshot.step = state.step;
    snapshot.time = state.time;
    snapshot.position = positions(grid, state.surface);
    snapshot.temperature = with_right_side(grid, state.temperature);
    snapshot.velocity = with_right_side(grid, state.velocity);
    snapshot.reference_map =
        mapped(snapshot.position, with_right_side(grid, state.reference_shift));
    snapshot.stress = mean_stress(state.stress);
    snapshot.pressure = state.stress.pressure;
    return snapshot;
}

Snapshot collect_snapshot(const Simulation& simulation) {
    Snapshot snapshot = collect_snapshot(simulation.grid(), simulation.state());
    snapshot.material_indicator =
        with_right_side(simulation.grid(), simulation.material_indicator());
    snapshot.material = simulation.material_fraction();
    snapshot.strain = simulation.strain();
    snapshot.strain_norm = simulation.strain_norm();
    return snapshot;
}

}  // namespace crawford
