/// A flame that swings.
#pragma once

#include <cmath>
#include <numbers>

#include "solver/scene/scene.hpp"

namespace crawford {

/// The surface as the flame heats it at a time [s]: every flux times 1 + a cos(2 pi f t) where the
/// scene modulates it, and untouched where not.
inline Surface heated_at(Surface surface, double time) {
    if (!surface.modulation) return surface;
    const auto [amplitude, frequency] = *surface.modulation;
    const double factor = 1.0 + amplitude * std::cos(2.0 * std::numbers::pi * frequency * time);
    for (double& flux : surface.heat_flux) flux *= factor;
    return surface;
}

}  // namespace crawford
