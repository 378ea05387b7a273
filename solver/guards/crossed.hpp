/// How many cells are crossed in one step.
#pragma once

#include <vector>

#include "solver/mesh/grid.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/state.hpp"

namespace crawford {

/// What was crossed in one step, at most.
struct Crossed {
    double columns = 0.0, rows = 0.0;  ///< by the solid
    double by_front = 0.0;             ///< columns, by a wave of the burning surface
};

/// Waves run over a burning surface: where it is phi too high it has been cooled by its neighbours, T'_t =
/// V dT phi_xx, and burns less, phi_t = -(V z/dT) T', z = Ea dT/(R T_s^2), so that
/// phi_tt = z V^2 phi_xx. A slope p runs at r_b p/sqrt(1 + p^2) besides. The faster of the two speeds.
double front_speed(double burn_rate, double z, double slope);

/// Columns that a wave may run in a step: heat and surface take turns, and that bears V sqrt(z)
/// dt/dx = 1 (Euler), 3.6 (bdf2) as measured. Slabs and sandwiches of 32 to 128 columns grew from 0.85,
/// with twice the flux, to 1.1; those of the usual flux hold 0.94.
double front_crossing_limit(Stepping scheme);

class Crossing {
public:
    Crossing(const Scene& scene, const Grid& grid);

    /// In the step that led to `after` from a surface `before`.
    Crossed of(const SurfaceField& before, const State& after) const;

    /// What is nearest its limit, as a share of it.
    double share_of_limit(const Crossed& crossed) const;

private:
    double by_front(const SurfaceField& before, const State& after) const;

    Grid grid_;
    std::vector<double> rows_in_a_metre_;  ///< at each node row, by the lower cell beside it [1/m]
    double columns_in_a_metre_;            ///< by the narrowest [1/m]
    double activation_;  ///< largest Ea/R [K]; 0 where the rate does not hang on T
    double cold_;        ///< temperature of the bottom [K]
    double front_limit_;
    int mechanics_every_;
};

}  // namespace crawford
