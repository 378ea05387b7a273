/// A block that is heated evenly: how much heat does it take?
#pragma once

#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

/// Values after each step.
struct Heating {
    std::vector<double> heat;         ///< brought so far [J/m^3]
    std::vector<double> temperature;  ///< [K]
};

/// Heats a block of one material from 300 K, quasi-statically and so fast that nothing is
/// conducted. It cannot widen and is free to rise; its surface burns nothing. The whole solver runs
/// (heat, stress, projection), with steps of second order.
Heating heat_evenly(const Material& material, HeatCapacity capacity, double heat, int steps);

}  // namespace crawford
