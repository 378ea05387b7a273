/// How solid and grid move while something is carried through the grid.
#pragma once

#include "solver/mesh/cell.hpp"

namespace crawford {

/// Refers to fields that must outlive it.
struct SolidMotion {
    const SurfaceField& surface;       ///< phi [m]
    const SurfaceField& surface_rate;  ///< phi_t [m/s]
    const NodeVectors& velocity;       ///< v [m/s]; empty for a rigid solid
};

/// Velocity of the solid relative to the grid [m/s]: (u, v - phi_t).
inline Vector relative_velocity(const SolidMotion& motion, const Node& node) {
    const Vector v = motion.velocity.empty() ? Vector::Zero() : motion.velocity(node.i, node.j);
    return {v.x(), v.y() - motion.surface_rate[size_t(node.i)]};
}

}  // namespace crawford
