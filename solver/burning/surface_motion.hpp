/// The regressing surface: phi_t = -r_b sqrt(1 + phi_x^2)   (paper eq. 9, 33).
#pragma once

#include "solver/mesh/grid.hpp"

namespace crawford {

/// phi_t [m/s] of each node column, by Godunov's Hamiltonian on third-order WENO slopes.
/// \param material_velocity of the surface nodes where the surface is carried by the material too;
/// empty where it is not.
SurfaceField surface_rate(const Grid& grid, const SurfaceField& surface,
                          const SurfaceField& burn_rate,
                          const std::vector<Vector>& material_velocity);

}  // namespace crawford
