/// The burning AP/binder pack of cases/scenes/pack.toml.
#pragma once

#include <vector>

#include "cases/kept_burn.hpp"
#include "cases/registry.hpp"

namespace crawford {

/// What a case may change about the burning pack.
struct PackBurning {
    bool mechanics = true;
    double flux = 1.0;  ///< times the heat flux of the scene
};

/// The burning pack at a fidelity: paper is 120 columns, 96 rows, steps of 25 us, until 0.135 s.
Scene burning_pack(Fidelity fidelity, const PackBurning& burning = {});

/// The pack with mechanics and the scene's own flux keeps its state this often [s], so that figure
/// 13 and its movie are served by one burn: 1.8 MB each on the paper's grid, 240 MB in all.
inline constexpr double filmed_every = 1e-3;

/// The snapshots of figure 13: at 35, 75, 105 and 135 parts in 135 of the time.
std::vector<Snapshot> four_times(const Burn& burn);

/// Means are taken from this time on [s]: it is two and a half times what a thermal layer takes to
/// form in AP at 0.45 cm/s, kappa/(rho c_p r_b^2).
inline constexpr double burning_since = 0.02;

/// Mean and standard deviation in time.
struct Course {
    double mean;
    double deviation;
};
/// Of what was recorded at equal intervals, from burning_since on.
Course course(const std::vector<double>& time, const std::vector<double>& values);

}  // namespace crawford
