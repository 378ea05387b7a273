#include "solver/scene/readings.hpp"

namespace crawford {

namespace {

bool reads_alike(const Numerics& a, const Numerics& b) {
    return a.thermal_stress == b.thermal_stress && a.stress_work == b.stress_work &&
           a.heat_capacity == b.heat_capacity && a.surface_motion == b.surface_motion;
}

}  // namespace

void apply(Readings readings, const Physics& physics, Numerics& numerics) {
    numerics.thermal_stress = ThermalStress::three_alpha_bulk;
    numerics.stress_work = numerics.thermal_stress;
    numerics.surface_motion = SurfaceMotion::burning;
    const bool counted_once = readings == Readings::consistent && physics.mechanics;
    numerics.heat_capacity =
        counted_once ? HeatCapacity::constant_volume : HeatCapacity::constant_pressure;
}

std::optional<Readings> readings_of(const Physics& physics, const Numerics& numerics) {
    for (const Readings readings : {Readings::paper, Readings::consistent}) {
        Numerics named = numerics;
        apply(readings, physics, named);
        if (reads_alike(named, numerics)) return readings;
    }
    return std::nullopt;
}

}  // namespace crawford
