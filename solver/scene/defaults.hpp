/// Defaults that follow from other keys of a scene.
#pragma once

#include "solver/scene/scene.hpp"

namespace crawford {

/// Kelvin-Voigt time [s] of the softer material: the scene's own or, where it has none,
/// viscous_time_at_a_corner where a surface of two materials burns and zero everywhere else.
double viscous_time(const Scene& scene);

/// What clustered columns are clustered about, a side of the strip [m]; zero where there is none.
double strip_side(const Scene& scene);

/// The scene with what it leaves to others of its keys put in: it then says what is used.
Scene resolved(Scene scene);

}  // namespace crawford
