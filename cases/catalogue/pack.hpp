/// The AP/binder pack of cases/scenes/pack.toml, burnt once however many cases look at it.
#pragma once

#include <memory>
#include <vector>

#include "cases/catalogue/registry.hpp"
#include "solver/output/snapshot.hpp"

namespace crawford {

/// What a case may change about the burning pack.
struct PackBurning {
    bool mechanics = true;
    double flux = 1.0;  ///< times the heat flux of the scene
};

/// The burning pack at a fidelity: paper is 120 columns, 96 rows, steps of 25 us, until 0.135 s.
Scene burning_pack(Fidelity fidelity, const PackBurning& burning = {});

/// What a burn leaves for figures.
struct PackBurn {
    Scene scene;
    std::vector<Snapshot> snapshots;          ///< at 35, 75, 105 and 135 parts in 135 of the time
    std::vector<double> time;                 ///< of each step [s]
    std::vector<double> mean_burn_rate;       ///< at each step [m/s]
    std::vector<double> largest_temperature;  ///< at each step [K]
    std::vector<double> largest_strain;  ///< at each step, on this grid; zero without mechanics
    std::vector<double> peak_time;       ///< of each value below [s], every 0.5 ms
    /// Mean strain norm over `peak_radius` about the largest; empty without mechanics.
    std::vector<double> peak_strain;
};
inline constexpr double peak_radius = 5e-6;  ///< [m]

/// Burns each scene to its end, side by side, or takes the burns of equal scenes that this program
/// has made or is just making.
std::vector<std::shared_ptr<const PackBurn>> burn_packs(const std::vector<Scene>& scenes,
                                                        const Request& request);

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
