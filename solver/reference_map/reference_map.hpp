/// Where each material point started: D(xi)/Dt = 0, F = (grad xi)^-1, E = (F^T F - I)/2   (paper
/// eq. 27-30, 46-48).
///
/// What is carried is the shift xi - (x, y), which obeys D(shift)/Dt = -v: it is exact in a free
/// stream and at the bottom, where material enters unshifted.
#pragma once

#include "solver/mesh/solid_motion.hpp"

namespace crawford {

/// Advances the shift [m] over dt with second-order ENO differences of `carried`; the bottom row is
/// held.
void advance_reference_map(const Grid& grid, const SolidMotion& motion, double dt,
                           const NodeVectors& carried, NodeVectors& shift);

/// Forward Euler: what is carried is the shift itself.
inline void advance_reference_map(const Grid& grid, const SolidMotion& motion, double dt,
                                  NodeVectors& shift) {
    advance_reference_map(grid, motion, dt, shift, shift);
}

/// Deformation gradient F of each cell, at its centre.
Lattice<Eigen::Matrix2d> deformation_gradient(const Grid& grid, const SurfaceField& surface,
                                              const NodeVectors& shift);

/// Green-St. Venant strain (F^T F - I)/2.
inline Eigen::Matrix2d green_strain(const Eigen::Matrix2d& f) {
    return 0.5 * (f.transpose() * f - Eigen::Matrix2d::Identity());
}

}  // namespace crawford
