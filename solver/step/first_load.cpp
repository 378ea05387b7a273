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

class FirstLoad {
public:
    FirstLoad(State& state, const LoadedSolid& solid)
        : state_(state), solid_(solid), dt_(loading_time(solid.scene)) {}

    void press() {
        settle();
        std::ranges::fill(state_.velocity.values(), Vector::Zero());
    }

private:
    /// Moves the solid to where its stress is in equilibrium.
    void settle() {
        solid_.projection.solve(state_.stress, state_.surface, state_.time, dt_, state_.velocity);
        solid_.stress.correct(state_.stress, state_.surface, state_.velocity, dt_);
        const bool carried =
            solid_.scene.numerics.surface_motion == SurfaceMotion::burning_with_material;
        if (carried) carry_surface();
        // The shift of a solid that has not moved is zero, and so is its gradient: it is added, not
        // carried.
        for (size_t k = 0; k < state_.reference_shift.values().size(); ++k)
            state_.reference_shift.values()[k] -= dt_ * state_.velocity.values()[k];
    }

    void carry_surface() {
        for (int i = 0; i < solid_.grid.node_columns(); ++i)
            state_.surface[size_t(i)] += dt_ * state_.velocity(i, solid_.grid.rows()).y();
    }

    State& state_;
    const LoadedSolid& solid_;
    double dt_;
};

}  // namespace

State under_first_load(State start, const LoadedSolid& solid) {
    FirstLoad(start, solid).press();
    return start;
}

}  // namespace crawford
