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
    // A slab by itself is not the run to a per cent, and the run stops at the limit.
    constexpr double margin = 1.02;
    if (guard.value < margin * *guard.limit) return guard;
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

Guard expansion_guard(const Scene& scene, const Material& material, double temperature) {
    // Measured on slabs of binder whose expansion was raised: 2.7 holds for 150 ms, at 3.5 the
    // deviator in the surface's row grows, the sooner the smaller the step. q1 and Euler hold.
    constexpr double held = 3.0;
    const bool in_doubt =
        scene.time.scheme == Stepping::bdf2 && scene.numerics.element == Element::bbar;
    Guard guard{
        .name = "expansion",
        .value = coupling_number(coupled(material, scene.numerics), Coupling::lagged, temperature),
        .limit = held};
    if (!in_doubt || guard.value <= held) return guard;
    guard.beyond = Beyond::remark;
    guard.text = fmt::format(
        "{} at {:.4g} K expands so strongly that stress may grow at the surface, sooner with a "
        "smaller time.step; take time.scheme = \"euler\"",
        material.name, temperature);
    return guard;
}

}  // namespace crawford
