#include "solver/step/modules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "solver/burning/flux_modulation.hpp"
#include "solver/reference_map/reference_map.hpp"
#include "solver/scene/defaults.hpp"
#include "solver/step/first_load.hpp"

namespace crawford {

namespace {

void check_finite(const NodeVectors& field, const char* module, const char* name) {
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j)
            if (!field(i, j).allFinite())
                throw NumericalFailure({.kind = FailureFields::Kind::not_finite,
                                        .module = module,
                                        .quantity = name,
                                        .place = FailurePlace{"node", i, j}});
}

void check_finite(const StressField& stress) {
    for (int i = 0; i < stress.pressure.columns(); ++i)
        for (int j = 0; j < stress.pressure.rows(); ++j) {
            const PlaneStress mean = stress.mean(i, j);
            if (!std::isfinite(mean.s11 + mean.s22 + mean.s33 + mean.s12))
                throw NumericalFailure({.kind = FailureFields::Kind::not_finite,
                                        .module = "stress",
                                        .quantity = "the stress",
                                        .place = FailurePlace{"cell", i, j}});
        }
}

/// phi_t [m/s] of a surface that goes from one place to another in the time `span`.
SurfaceField rate_between(const SurfaceField& from, const SurfaceField& to, double span) {
    SurfaceField rate(from.size());
    for (size_t i = 0; i < rate.size(); ++i) rate[i] = (to[i] - from[i]) / span;
    return rate;
}

}  // namespace

Simulation::Modules::Modules(Scene s, Sources given)
    : scene(std::move(s)),
      sources(std::move(given)),
      grid(scene.domain, strip_side(scene)),
      materials(scene.morphology, grid, scene.numerics),
      law(scene.physics.regression, scene.surface),
      front(front_motion(scene.numerics.front, grid, materials, law)),
      checkerboard(grid, materials, scene.numerics.element),
      state(initial_state(scene, grid)) {
    if (scene.surface.ripple) materials.follow(state.surface, state.reference_shift);
    if (scene.physics.heat) heat = std::make_unique<HeatStep>(scene, grid, materials, law, sources);
    if (!scene.physics.mechanics) return;
    stress = std::make_unique<StressStep>(scene, grid, materials, checkerboard, sources);
    projection = std::make_unique<Projection>(scene, grid, materials, checkerboard, sources);
}

SurfaceField Simulation::Modules::surface_rate_of(const SurfaceField& surface,
                                                  const NodeField& temperature,
                                                  const NodeVectors& velocity,
                                                  double length) const {
    const bool carried = scene.numerics.surface_motion == SurfaceMotion::burning_with_material;
    std::vector<Vector> of_material;
    if (carried && !velocity.empty())
        for (int i = 0; i < grid.node_columns(); ++i)
            of_material.push_back(velocity(i, grid.rows()));
    return front->rate({surface, temperature, of_material}, length);
}

void Simulation::Modules::load() {
    const Physics& p = scene.physics;
    if (stress && scene.surface.pressure > 0.0 && (p.heat || p.regression != Regression::none))
        state = under_first_load(state, {scene, grid, *stress, *projection});
    materials.follow(state.surface, state.reference_shift);
    forget_residual();
    loaded = true;
}

State Simulation::Modules::advanced(const State& now, double end, double length) {
    State next;
    if (scene.time.mechanics_every > 1) {
        next = now;
        advance_in_turns(next, now, end, length);
    } else if (now.previous) {
        const double ratio = length / now.length;
        const TwoStepWeights w = bdf2_weights(ratio);
        next = combination(w.of_now, now, -w.of_before, *now.previous);
        advance(next, combination(1.0 + ratio, now, -ratio, *now.previous),
                bdf2_step(now.time, length, ratio), length);
    } else {
        next = now;
        advance(next, now, euler_step(now.time, length), length);
    }
    next.step = now.step + 1;
    next.time = end;
    next.length = length;
    return next;
}

void Simulation::Modules::advance(State& next, const State& now, TimeStep step, double length) {
    const SurfaceField base = next.surface;
    move_front(next, now, step, length);
    if (stress) move_solid(next, now, base, step);
}

void Simulation::Modules::advance_in_turns(State& next, const State& now, double end,
                                           double length) {
    move_front(next, now, euler_step(now.time, length), length);
    if (!moves_solid_at(now.step + 1)) {
        if (materials.moves()) materials.follow(next.surface);
        return;
    }
    const State& solid = solid_of(now);
    const TimeStep whole = euler_step(solid.time, end - solid.time);
    // Of the velocity's own time: what is left of the two would alternate otherwise.
    if (heat)
        material_rate(
            grid, solid.temperature, next.temperature,
            {solid.surface, rate_between(solid.surface, next.surface, whole.span), solid.velocity},
            whole.span, next.temperature_rate);
    if (materials.moves()) materials.follow(solid.surface);
    move_solid(next, solid, solid.surface, whole);
}

void Simulation::Modules::move_front(State& next, const State& now, TimeStep step, double length) {
    if (heat) {
        step.implicit_heat = std::max(step.implicit_heat, heat->least_implicit(step.span));
        move_heat(next, now, step, length);
    }
    move_surface(next, now, step, length);
}

void Simulation::Modules::move_heat(State& next, const State& now, const TimeStep& step,
                                    double length) {
    if (scene.surface.modulation)
        law = {scene.physics.regression, heated_at(scene.surface, step.heat_time())};
    const SurfaceField rate = surface_rate_of(now.surface, now.temperature, now.velocity, length);
    const HeatMotion motion{{now.surface, rate, now.velocity}, now.temperature_rate};
    stopwatch.measure("heat", [&] {
        const NodeField base = next.temperature;
        heat->advance(next.temperature, now.temperature, motion, step);
        if (!next.temperature_rate.empty() && scene.time.mechanics_every == 1)
            material_rate(grid, base, next.temperature, motion, step.span, next.temperature_rate);
    });
}

/// phi' = phi + dt phi_t, with the burn rate of the new temperature (paper sec. 3.5).
void Simulation::Modules::move_surface(State& next, const State& now, const TimeStep& step,
                                       double length) {
    stopwatch.measure("burning", [&] {
        const SurfaceField rate =
            surface_rate_of(now.surface, next.temperature, now.velocity, length);
        for (size_t i = 0; i < rate.size(); ++i) {
            next.surface[i] += step.span * rate[i];
            if (!std::isfinite(next.surface[i]))
                throw NumericalFailure({.kind = FailureFields::Kind::not_finite,
                                        .module = "burning",
                                        .quantity = "the surface",
                                        .place = FailurePlace{"node column", int(i)}});
        }
    });
}

void Simulation::Modules::move_solid(State& next, const State& now, const SurfaceField& base,
                                     const TimeStep& step) {
    forget_residual();
    const SurfaceField rate = rate_between(base, next.surface, step.span);
    const SolidMotion old_motion{now.surface, rate, now.velocity};

    stopwatch.measure("stress", [&] {
        stress->predict(next.stress, now.stress, old_motion, next.temperature_rate, step);
    });
    // What the map carries must be where the projection's grid is: the map takes the explicit
    // velocity then, and not that of the projection.
    const bool map_first = scene.morphology.indicator == Indicator::reference_map;
    if (map_first) move_map(next, now, rate, now.velocity, step);
    if (materials.moves()) stopwatch.measure("morphology", [&] { follow_material(next); });
    stopwatch.measure("projection", [&] {
        solver_iterations =
            projection->solve(next.stress, next.surface, step.end, step.span, next.velocity);
        check_finite(next.velocity, "projection", "velocity");
    });
    stopwatch.measure("stress", [&] {
        stress->correct(next.stress, next.surface, next.velocity, step.span);
        check_finite(next.stress);
    });
    if (!map_first) move_map(next, now, rate, next.velocity, step);
}

void Simulation::Modules::move_map(State& next, const State& now, const SurfaceField& rate,
                                   const NodeVectors& velocity, const TimeStep& step) {
    if (next.reference_shift.empty()) return;
    stopwatch.measure("reference map", [&] {
        const SolidMotion motion{now.surface, rate, velocity};
        advance_reference_map(grid, motion, step.span, now.reference_shift, next.reference_shift);
        check_finite(next.reference_shift, "reference map", "the map");
    });
}

/// The grid has moved through the morphology, or the morphology with the solid: cells that
/// became softer cannot hold what they held.
void Simulation::Modules::follow_material(State& next) {
    shear_modulus_before = materials.shear_modulus();
    materials.follow(next.surface, next.reference_shift);
    stress->soften(next.stress, shear_modulus_before);
}

/// Between two moves of the solid that of the last: its materials have moved on since.
double Simulation::Modules::residual() {
    if (residual_) return *residual_;
    const State& solid = solid_of(state);
    if (&solid != &state && materials.moves()) materials.follow(solid.surface);
    residual_ = projection->residual(solid.stress, solid.velocity, solid.surface, solid.time);
    if (&solid != &state && materials.moves()) materials.follow(state.surface);
    return *residual_;
}

std::shared_ptr<const State> Simulation::Modules::remembered(State now) const {
    if (scene.time.scheme == Stepping::euler) {
        if (moves_solid_at(now.step + 1)) return nullptr;
        return moves_solid_at(now.step) ? std::make_shared<const State>(std::move(now))
                                        : std::move(now.previous);
    }
    now.previous.reset();
    if (stress && materials.moves()) stress->soften(now.stress, shear_modulus_before);
    return std::make_shared<const State>(std::move(now));
}

}  // namespace crawford
