/// The slab that tests of its truths start from.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "reference/slab.hpp"

namespace crawford::reference {

inline constexpr std::array models = {SlabModel::thermal, SlabModel::kuznetsov_stewart,
                                      SlabModel::eulerian, SlabModel::mass_conserving};
inline constexpr std::array readings = {ThermalStress::alpha_k, ThermalStress::three_alpha_k};
inline constexpr std::array capacities = {HeatCapacity::constant_pressure,
                                          HeatCapacity::constant_volume};

/// The paper's one-dimensional study: 0.45 cm/s, 2 MPa, no heat of reaction; Q in cal/(s cm^2).
inline SlabConditions study(const Material& material, double flux) {
    return {.material = without_reaction(material),
            .heat_flux = flux * calorie_per_second_per_cm2,
            .burn_rate = 0.0045,
            .pressure = 2e6,
            .cold_temperature = 300.0};
}

/// Points from the surface down to `bottom` [m].
inline std::vector<double> depths(double bottom, int count) {
    std::vector<double> y;
    for (int i = 0; i < count; ++i) y.push_back(-bottom * i / (count - 1));
    return y;
}

/// Error of a value.
inline double relative(double value, double truth) {
    return std::abs(value / truth - 1.0);
}

}  // namespace crawford::reference
