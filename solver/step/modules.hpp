/// The modules of a simulation, and how a step goes through them.
#pragma once

#include <memory>
#include <optional>

#include "solver/burning/front_motion.hpp"
#include "solver/heat/heat_step.hpp"
#include "solver/projection/projection.hpp"
#include "solver/step/simulation.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

struct Simulation::Modules {
    Scene scene;
    Sources sources;
    Grid grid;
    MaterialMap materials;
    BurningLaw law;
    std::unique_ptr<FrontMotion> front;
    Checkerboard checkerboard;
    std::unique_ptr<HeatStep> heat;
    std::unique_ptr<StressStep> stress;
    std::unique_ptr<Projection> projection;
    State state;
    bool loaded = false;  ///< state is under the first load
    Stopwatch stopwatch;
    int solver_iterations = 0;
    double regression_rate = 0.0;    ///< of the last step [m/s]
    CellField shear_modulus_before;  ///< of the last step, where the morphology moves

    Modules(Scene s, Sources given);

    /// Puts the state at the start under its load. Of a solid that neither burns nor is heated the
    /// load is all there is, and the velocity of the first step is the answer.
    void load();

    /// The state one step of `length` after `now`, at the time `end`.
    State advanced(const State& now, double end, double length);

    /// Keeps `now` for the next step to look back at, as soft as the material has become since.
    std::shared_ptr<const State> remembered(State now) const;

    bool moves_solid_at(long step) const { return step % scene.time.mechanics_every == 0; }

    /// Where stress, velocity and map stand: at the last step that moved the solid.
    const State& solid_of(const State& now) const {
        return moves_solid_at(now.step) ? now : *now.previous;
    }

    /// Of equilibrium, relative to the load of the stress, where the solid stands.
    double residual();

    /// For a state that comes from elsewhere.
    void forget_residual() { residual_.reset(); }

private:
    std::optional<double> residual_;  ///< once it was asked for, until the solid moves

    /// phi_t of a surface whose nodes have this temperature and velocity.
    SurfaceField surface_rate_of(const SurfaceField& surface, const NodeField& temperature,
                                 const NodeVectors& velocity, double length) const;

    /// One step. `next` enters as the base of the step; `now` is the explicit state.
    void advance(State& next, const State& now, TimeStep step, double length);

    /// Heat and surface each step, with the velocity of the last step that moved the solid. The
    /// solid every so many steps, over all the time since: one long step of the same equations.
    void advance_in_turns(State& next, const State& now, double end, double length);

    void move_front(State& next, const State& now, TimeStep step, double length);
    void move_heat(State& next, const State& now, const TimeStep& step, double length);
    void move_surface(State& next, const State& now, const TimeStep& step, double length);
    void move_solid(State& next, const State& now, const SurfaceField& base, const TimeStep& step);
    void move_map(State& next, const State& now, const SurfaceField& rate,
                  const NodeVectors& velocity, const TimeStep& step);
    void follow_material(State& next);
};

}  // namespace crawford
