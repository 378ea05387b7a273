#include "solver/heat/coupling_number.hpp"

namespace crawford {

double coupling_number(const CoupledSolid& solid, Coupling coupling, double temperature) {
    const double confined = solid.bulk_modulus + 4.0 / 3.0 * solid.shear_modulus;
    const double answer =
        solid.heat_of_stretch * solid.stress_of_heat * temperature / confined;  // [J/(m^3 K)]
    if (coupling == Coupling::lagged) return answer / solid.heat_capacity;
    const double split = solid.split_capacity(temperature);
    return (answer - split) / (solid.heat_capacity + split);
}

double coupling_limit(Stepping scheme) {
    return scheme == Stepping::euler ? 1.0 : 1.0 / 3.0;
}

double coupling_of_a_lost_step(Stepping scheme) {
    constexpr double growth = 1.1;  // of the root z = -growth
    return scheme == Stepping::euler ? 1.0 : growth * growth / (1.0 + 2.0 * growth);
}

std::string coupling_condition(Coupling coupling, Stepping scheme) {
    const std::string form = coupling == Coupling::lagged ? "\"lagged\"" : "\"adiabatic\"";
    const std::string with = scheme == Stepping::bdf2 ? " with time.scheme = \"bdf2\"" : "";
    return "for numerics.coupling = " + form + with;
}

std::string coupling_advice(const CoupledSolid& solid, Coupling coupling, Stepping scheme,
                            double temperature) {
    // With one beta the split is stable for any.
    std::string one_beta = "take the same numerics.stress_work as numerics.thermal_stress";
    if (coupling == Coupling::adiabatic) return one_beta;
    const std::string split = "take numerics.coupling = \"adiabatic\"";
    const bool helps =
        coupling_number(solid, Coupling::adiabatic, temperature) < coupling_limit(scheme);
    return helps ? split : split + " and " + one_beta;
}

}  // namespace crawford
