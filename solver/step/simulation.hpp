/// The order of a step (paper section 3.5):
/// heat, burning, stress, projection, stress, reference map; the map comes before the projection
/// where it carries the morphology.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/mesh/grid.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/sources.hpp"
#include "solver/step/state.hpp"
#include "solver/step/stopwatch.hpp"

namespace crawford {

/// What a step leaves to be read, one row of the history.
struct Summary {
    double mean_burn_rate = 0.0;     ///< over the true length of the surface [m/s]
    double regression_rate = 0.0;    ///< drop of the mean height in the last step, per time [m/s]
    double largest_temperature = 0;  ///< [K]
    double least_temperature = 0;    ///< [K]
    double largest_strain = 0;       ///< in the scene's strain norm
    double residual = 0;             ///< of div sigma = 0, relative to the load of the stress
    int solver_iterations = 0;       ///< of the projection's linear solver; 0 for a direct one
};

class Simulation {
public:
    /// Allocates what the scene asks for and nothing else, and sets the start of the model:
    /// cold, at rest, unstressed.
    explicit Simulation(Scene scene, Sources sources = {});
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Advances the state by one step of `length`, which ends at `end` [s]: given apart, so that
    /// neither piles up rounding.
    /// \throws NumericalFailure naming the step, the module and the place; state() is then still the
    /// last good one.
    void step(double end, double length);

    /// Goes on from a checkpoint, bit for bit as if never stopped. A state that looks back and has no
    /// length came by a step of time.step.
    /// \throws InputError if the state's fields or sizes are not those of the scene.
    void restore(State state);

    /// Drops what the linear solver keeps between steps. Done at each checkpoint, so that the run
    /// that goes on and the run that restarts there do the same arithmetic.
    void forget_factorisation();

    const Scene& scene() const;
    const Grid& grid() const;
    const State& state() const;
    Summary summary() const;
    std::vector<ModuleTime> timing() const;

    // What follows from the state, computed when asked.
    CellField material_fraction() const;   ///< of the first material in each cell, 0 to 1
    NodeField material_indicator() const;  ///< Phi: 1 in the first material, -1 in the second
    int solver_iterations() const;         ///< of the last step's linear solver; 0 for a direct one
    SurfaceField burn_rate() const;        ///< r_b of each node column [m/s]
    Lattice<Eigen::Matrix2d> deformation_gradient() const;  ///< F of each cell; empty without a map
    /// Green-St. Venant strain E11, E22, E12 of each cell (paper eq. 30, 48); empty without a
    /// reference map.
    Lattice<std::array<double, 3>> strain() const;
    CellField strain_norm() const;

private:
    struct Modules;
    std::unique_ptr<Modules> modules_;
};

}  // namespace crawford
