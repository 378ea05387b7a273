/// Everything a step starts from: what a checkpoint holds.
/// A field the scene does not ask for is empty.
#pragma once

#include <memory>

#include "solver/element/stress_field.hpp"
#include "solver/mesh/grid.hpp"

namespace crawford {

struct State {
    long step = 0;
    double time = 0.0;            ///< [s]
    double length = 0.0;          ///< of the step that led here [s]; 0 at the start
    SurfaceField surface;         ///< phi [m] of each node column
    NodeField temperature;        ///< T [K]
    NodeVectors velocity;         ///< v [m/s]
    StressField stress;           ///< sigma [Pa]
    CellField temperature_rate;   ///< DT/Dt of the last step [K/s], where the stress work is split
    NodeVectors reference_shift;  ///< xi - (x, y) [m]; as a shift it is exact in a free stream
    /// The state one step before, where time.scheme looks back that far; between two moves of the
    /// solid (time.mechanics_every) that of the last. Its own is always empty.
    std::shared_ptr<const State> previous;
};

/// Cold, at rest and unstressed below a level surface or the scene's ripple, with the fields that
/// the scene asks for and no others.
State initial_state(const Scene& scene, const Grid& grid);

/// Whether the fields of both have the same sizes.
bool same_shape(const State& a, const State& b);

/// a x + b y, field by field; time, step, length and previous are those of x.
/// Both must be states of the same scene.
State combination(double a, const State& x, double b, const State& y);

}  // namespace crawford
