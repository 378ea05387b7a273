/// Numbers of the grid and the step: does the grid hold what burns in it, and does nothing cross a
/// cell in a step?
#pragma once

#include <optional>

#include "solver/guards/guard.hpp"
#include "solver/guards/steady_slab.hpp"
#include "solver/mesh/grid.hpp"

namespace crawford {

/// r_b h/D in the rows that hold the thermal layer; beyond 2 central differences undershoot.
Guard cell_peclet(const Grid& grid, const Material& material, double burn_rate);

/// How far [K] the discrete steady layer falls below the bottom's temperature.
double deepest_undershoot(const Scene& scene, const Grid& grid, const Material& material,
                          const SteadySlab& slab);
Guard undershoot(double kelvin);

/// Columns in the thinnest layer of a sandwich or across the smallest disc, as wide as they are in the mean.
/// In a sandwich too few are remarked where they are wide beside the thermal layer, or the strip leads.
std::optional<Guard> columns_in_layer(const Scene& scene, double burn_rate);

/// r_b dx (1 + g)/D, g = T beta_w beta_s/(P rho c): the columns' Peclet number for heat that enters
/// from the side and is taken up by expansion. `slab` is as hot as the material and burns as fast as
/// the whole.
Guard column_peclet(const Scene& scene, const Grid& grid, const Material& material,
                    const SteadySlab& slab);

/// Thermal layers D/r_b over the depth of the window.
Guard layers_in_window(const Scene& scene, const Material& material, double burn_rate);

/// D dt/h^2 in the finest cells, and how long a step remembers a zigzag.
Guard fourier(const Scene& scene, const Grid& grid, const Material& material);
double fourier_number(const Grid& grid, const Material& material, double dt);
Guard fourier(double number);  ///< as it is met: only told

/// What a sweep of the line relaxation leaves, (2 a/(1 + 2 a))^2 with a = D dt/dx^2 times the
/// implicit share.
Guard relaxation(const Scene& scene, const Grid& grid, const Material& material);
Guard relaxation(double contraction, const Scene& scene);

/// p L/(P h), the cells by which the first load moves the surface.
Guard pressing(const Scene& scene, const Grid& grid, const Material& material);

/// Cells that the solid crosses in a step, at a predicted rate; where it is met, mechanics has its
/// own check.
Guard predicted_crossing_y(const Scene& scene, const Grid& grid, double burn_rate);
Guard crossing_x(double cells);
Guard crossing_y(double cells);

/// Columns that a wave of the burning surface runs in a step (crossed.hpp).
Guard front_crossing(double columns, Stepping scheme);

}  // namespace crawford
