#include "solver/step/first_load.hpp"

#include <algorithm>

#include "solver/scene/defaults.hpp"

namespace crawford {

namespace {

/// So slow that the Kelvin-Voigt stress has no part in the equilibrium [s].
double loading_time(const Scene& scene) {
    constexpr double viscous_share = 1e-6;
    return std::max(scene.time.step, viscous_time(scene) / viscous_share);
}

void carry(SurfaceField& surface, const NodeVectors& velocity, const Grid& grid, double dt) {
    for (int i = 0; i < grid.node_columns(); ++i)
        surface[size_t(i)] += dt * velocity(i, grid.rows()).y();
}

}  // namespace

State under_first_load(State state, const LoadedSolid& solid) {
    const double dt = loading_time(solid.scene);
    solid.projection.solve(state.stress, state.surface, state.time, dt, state.velocity);
    solid.stress.correct(state.stress, state.surface, state.velocity, dt);
    if (solid.scene.numerics.surface_motion == SurfaceMotion::burning_with_material)
        carry(state.surface, state.velocity, solid.grid, dt);
    // The shift of a solid that has not moved is zero, and so is its gradient: it is added, not
    // carried.
    for (size_t k = 0; k < state.reference_shift.values().size(); ++k)
        state.reference_shift.values()[k] -= dt * state.velocity.values()[k];
    std::ranges::fill(state.velocity.values(), Vector::Zero());
    return state;
}

}  // namespace crawford
