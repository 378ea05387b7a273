#include "solver/guards/coupling_guard.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/guards/steady_slab.hpp"

namespace crawford {

Guard coupling_guard(const Scene& scene, const Material& material, double temperature) {
    const Numerics& n = scene.numerics;
    const Stepping scheme = scene.time.scheme;
    CoupledSolid solid = coupled(material, n);
    solid.heat_capacity = heat_capacity(solid, n.heat_capacity, temperature);
    Guard guard{.name = "coupling",
                .value = std::max(0.0, coupling_number(solid, n.coupling, temperature)),
                .limit = coupling_limit(scheme)};
    if (guard.value < *guard.limit) return guard;
    guard.beyond = Beyond::refusal;
    guard.text =
        fmt::format("{}, {} at {:.4g} K: stress work and heat would alternate and grow; {}",
                    coupling_condition(n.coupling, scheme), material.name, temperature,
                    coupling_advice(solid, n.coupling, scheme, temperature));
    return guard;
}

Guard heat_capacity_guard(const Scene& scene, const Material& material, double temperature) {
    const Numerics& n = scene.numerics;
    Guard guard{.name = "heat_capacity",
                .value = heat_capacity(coupled(material, n), n.heat_capacity, temperature),
                .limit = 0.0,
                .is_least = true};
    if (guard.value > 0.0 || n.coupling == Coupling::adiabatic) return guard;
    guard.beyond = Beyond::refusal;
    guard.text = fmt::format(
        "J/(m3 K), rho c_v of {} at {:.4g} K for numerics.coupling = \"lagged\"; take "
        "numerics.coupling = \"adiabatic\"",
        material.name, temperature);
    return guard;
}

}  // namespace crawford
