/// One material burning by itself, level and steady: what a scene can be asked before it is run.
///
/// With beta_s/P = theta and D = T - T_0, the solid moves at r_b exp(theta D), and what enters
/// through the surface heats and stretches it (docs/theory.md, "One slab"):
///
///     Q + q_s rho r_b = r_b integral from T_0 to T_s of (rho c + beta_w theta T) exp(theta D) dT
///
/// A rigid solid has theta = 0.
#pragma once

#include <optional>

#include "solver/heat/coupling_number.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

struct SteadySlab {
    double surface_temperature;  ///< T_s [K]
    double burn_rate;            ///< r_b [m/s]
};

/// The hottest surface that is looked for [K]: above it no solid is left, and no constant of one
/// holds.
inline constexpr double hottest_surface = 10'000.0;

/// How the surface of a slab would have to be.
enum class Burning {
    steady,    ///< there is a solution
    too_cold,  ///< pyrolysis absorbs more than the flux even at the temperature of the bottom
    too_hot,   ///< the surface would be hotter than hottest_surface
    none       ///< nothing burns: no heat, no flux or no regression
};

struct SlabAnswer {
    Burning burning;
    SteadySlab slab;  ///< also where it is too cold or too hot; not where nothing burns
};

/// \param material of the scene's morphology, by its number
SlabAnswer steady_slab(const Scene& scene, size_t material);

/// Zeldovich number z = Ea (T_s - T_0)/(R T_s^2): how strongly a rate of activation temperature Ea/R [K] answers T_s.
double zeldovich_number(double activation_temperature, double hot, double cold);

/// Ea/R [K] of the material that answers it most; 0 where no rate hangs on T.
double largest_activation(const Scene& scene);

/// By how much faster than r_b the solid moves at the heated surface [m/s], r_b (exp(theta D) - 1).
double speed_of_expansion(const Scene& scene, const Material& material, const SteadySlab& slab);

/// What the coupling of a material is made of; its heat capacity is c_p's.
CoupledSolid coupled(const Material& material, const Numerics& numerics);

/// rho c at a temperature: with c_v it falls as the solid is heated.
double heat_capacity(const CoupledSolid& solid, HeatCapacity reading, double temperature);

}  // namespace crawford
