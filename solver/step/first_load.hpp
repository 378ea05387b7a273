/// The chamber's pressure comes on before the first step, all at once.
///
/// It presses the solid by some p L/P whatever the step. Taken for a velocity, that would carry
/// every field by as much in the next step, across whole cells at 30 MPa, and no smaller step would
/// help. So the solid is pressed at rest: stress and reference map find their equilibrium, nothing is
/// carried, and the velocity is zero again. The temperature of the start is that of the pressed
/// solid.
#pragma once

#include "solver/projection/projection.hpp"
#include "solver/step/state.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

/// The equations that a solid under its first load has to meet.
struct LoadedSolid {
    const Scene& scene;
    const Grid& grid;
    StressStep& stress;
    Projection& projection;
};

/// The state at the start as it is under its load.
/// \throws NumericalFailure if the linear solver fails.
State under_first_load(State state, const LoadedSolid& solid);

}  // namespace crawford
