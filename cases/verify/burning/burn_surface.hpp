/// A surface burnt by itself, without heat.
#pragma once

#include <algorithm>

#include "cases/verify/ssp_step.hpp"
#include "solver/mesh/lattice.hpp"

namespace crawford {

/// Steps a surface to `duration` [s] by Runge-Kutta steps of third order.
/// \param rate (surface, dt) -> phi_t of each node column [m/s]
template <class Rate>
SurfaceField burn_surface(SurfaceField surface, double duration, int steps, const Rate& rate) {
    const double dt = duration / steps;
    const auto blend = [](double a, const SurfaceField& x, double b, const SurfaceField& y) {
        SurfaceField sum(x.size());
        std::ranges::transform(x, y, sum.begin(),
                               [&](double p, double q) { return a * p + b * q; });
        return sum;
    };
    const auto euler = [&](const SurfaceField& phi) { return blend(1.0, phi, dt, rate(phi, dt)); };
    for (int n = 0; n < steps; ++n) surface = ssp_step(surface, euler, blend);
    return surface;
}

}  // namespace crawford
