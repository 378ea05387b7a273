/// Four solids between a rigid conductor and the paper's: what they differ by tells how much of a
/// lower temperature is mechanics.
#pragma once

#include <array>

#include "reference/slab_conditions.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// In this order, each with one assumption more:
/// - rigid: conducts, with c_p
/// - small_strain: thermo-elastic with c_v, at the limit of small strain
/// - c_v: the same at its true strain, at constant density
/// - c_p: as the paper, stress work beside c_p
inline constexpr std::array<const char*, 4> solid_names = {"rigid", "small_strain", "c_v", "c_p"};

/// The four from a scene without mechanics and the same with it. For small strain K and mu are
/// multiplied by 100^2, the gas pressure by 100, and alpha is divided by 100: stress grows a
/// hundredfold and strain shrinks to a hundredth, their product and beta^2/K stay what they are.
std::array<Scene, 4> four_solids(const Scene& rigid, const Scene& coupled);

/// The four of a slab, for its exact solution; small strain is Kuznetsov and Stewart's limit.
std::array<reference::SlabConditions, 4> four_solids(const reference::SlabConditions& slab);

/// What a number of the four solids, one each, changes by from the rigid conductor to the paper's,
/// in parts; `whole` is their sum.
struct Parts {
    explicit Parts(const std::array<double, 4>& values);

    double whole;
    double mechanics;  ///< from rigid to small strain
    double stretch;    ///< from small to true strain, rho kept constant
    double twice;      ///< from c_v to c_p beside the stress work
};

}  // namespace crawford
