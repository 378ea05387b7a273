/// Numbers of the burning itself: is there a solution, does it stay, does the step follow it?
#pragma once

#include <optional>

#include "solver/guards/guard.hpp"
#include "solver/guards/steady_slab.hpp"
#include "solver/mesh/grid.hpp"

namespace crawford {

/// Refuses a material that has no burning solution; nothing where it has one or does not burn.
std::optional<Guard> burning_solution(const Scene& scene, size_t material,
                                      const SlabAnswer& answer);

/// z Theta against (1 + sqrt(1 + 8 z))/2, z = Ea dT/(R T_s^2), Theta = q_s/(c dT): from there on the
/// front of an exothermic surface swings and grows. That is physics.
Guard onset(const Scene& scene, const Material& material, const SteadySlab& slab);

/// N = r_b^2 z dt/D: heat takes the burn rate of the last step, so a surface that is too hot moves
/// too fast, and that takes exp(r_b y/D) of temperature away. Conduction does not see this shape, so
/// Crank-Nicolson alternates for ever at N = 2. Where a step is more implicit by e (bdf2: wholly,
/// and 4/dt = 3 r_b^2 z/D), a layer at the surface helps: N = 2 (1 - z Theta/l)/(1 - 1/l), l^2 - l =
/// 2 D/(e r_b^2 dt).
double front_limit(const Scene& scene, const Grid& grid, const Material& material,
                   const SteadySlab& slab);

/// N of a material that burns so, in a step of dt [s].
double front_coupling_number(const Scene& scene, const Material& material,
                             const SteadySlab& burning, double dt);

/// N against 0.5, beyond which ignition is no longer followed; refused beyond front_limit.
Guard front_coupling(const Scene& scene, const Grid& grid, const Material& material,
                     const SteadySlab& slab);
Guard front_coupling(double number);  ///< as it is met: only told

/// Columns that waves of the surface of a material run in a step. Refused at half as much again as is
/// remarked: a part that burns by itself may burn faster than it will beside another.
Guard predicted_front_crossing(const Scene& scene, const Grid& grid, const Material& material,
                               const SteadySlab& slab);

/// How far what has burnt at the end is off since it began to burn, over what has burnt: a slab that
/// burns r t is off by some r dt and 0.08 h^2 r/D.
Guard ignition(const Scene& scene, const Grid& grid, const Material& material,
               const SteadySlab& slab, double flux);

/// Slope of the slowest material beside an interface that recedes at this rate [m/s]:
/// r sqrt(1 + p^2) = V at the temperature at which another burns at V level.
double predicted_slope(const Scene& scene, double regression_rate);

/// Largest slope of the surface.
Guard slope(double largest);

/// Largest part of the burn rate by which it goes up and down from step to step.
Guard alternation(double part);

}  // namespace crawford
