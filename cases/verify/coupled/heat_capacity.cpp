/// # Heat capacity: with c_v in its heat equation, does the solver's solid take c_p?
///
/// The stress work beta T div v supplies what a solid takes for its expansion, so the capacity
/// beside it is c_v = c_p - beta^2 T/(rho K) (`numerics.heat_capacity = "c_v"`;
/// cases/explore/model_form.cpp has the thermodynamics). The simplest trial: heat a block evenly
/// and see what it takes. Binder, which hardly resists its change of shape, expands as if nothing
/// held it and must take rho c_p for each degree, to the 1 - K/P = 3e-4 of the difference that its
/// shear modulus holds back. AP that cannot widen takes less, by 0.53 of its own small c_p - c_v.
/// Neither number is the solver's nor its equation's: they follow from a free energy
/// (tests/reference/adiabatic_column_test.cpp). With c_p the block of binder takes nearly half as
/// much again, which is the expansion counted twice.
///
/// The burning slab has an exact solution with c_v too (reference/slab_energy.hpp), to which the
/// solver must come at second order as it does with c_p (cases/verify/slab/slab.cpp).

#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/coupled/heated_block.hpp"
#include "reference/slab.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double cold = 300.0;  // [K]
constexpr double heat = 8e8;    // [J/m^3]: 690 K of binder
constexpr int heating_steps = 256;

/// Heat that a heated block has taken, in parts of rho c_p (T - T0); free to expand it takes 1.
double taken(const Material& material, HeatCapacity capacity) {
    const Heating block = heat_evenly(material, capacity, heat, heating_steps);
    const double rise = block.temperature.back() - cold;
    return block.heat.back() / (material.density * material.specific_heat * rise);
}

/// beta^2/K [J/(m^3 K^2)] with beta = 3 alpha K: rho (c_p - c_v)/T.
double expansion(const reference::Material& m) {
    return 9.0 * m.thermal_expansion * m.thermal_expansion * m.bulk_modulus;
}

/// The same by thermodynamics, with c_v: 1, less the share 1 - K/P of c_p - c_v that a block which
/// cannot widen does not take. Where both are small T - T0 is heat/(rho c_p), and c_p - c_v is that
/// of the mean temperature.
double confined(const reference::Material& m) {
    const double capacity = m.density * m.specific_heat;
    const double mean_temperature = cold + heat / capacity / 2.0;
    const double held_back = 1.0 - m.bulk_modulus / m.uniaxial_modulus();
    return 1.0 - held_back * expansion(m) * mean_temperature / capacity;
}

reports::Study heated_block() {
    constexpr auto binder_v = "binder with c_v: heat taken/(rho c_p (T - T0))";
    constexpr auto binder_p = "binder with c_p: the same";
    constexpr auto ap_v = "AP with c_v: the same";
    const double binder_confined = confined(reference::binder());
    const double ap_confined = confined(reference::ap());
    const auto near = [](double truth) { return between(truth - 1e-5, truth + 1e-5); };
    reports::Study study("heat-capacity, heated block");
    study.refines("steps", {heating_steps})
        .measure([=](int steps) {
            return reports::Measurement(1.0 / steps)
                .value(binder_v, taken(htpb_binder(), HeatCapacity::constant_volume))
                .value(binder_p, taken(htpb_binder(), HeatCapacity::constant_pressure))
                .value(ap_v, taken(ammonium_perchlorate(), HeatCapacity::constant_volume));
        })
        .covers({term::heat_storage, term::stress_work, term::thermal_stress})
        .bound(binder_v, heating_steps, near(binder_confined),
               "free to expand it would take 1; 4 mu/(3 P) = 3e-4 of c_p - c_v is held back")
        .bound(binder_p, heating_steps, between(1.44, 1.46),
               "a quarter more at 300 K, nearly half in the mean up to 777 K: counted twice")
        .bound(ap_v, heating_steps, near(ap_confined),
               "held sideways, AP takes 0.47 of c_p - c_v, which is 0.3 % of c_p");
    return study;
}

Slab burning(const std::string& material, double flux, int cells) {
    return slab(material, {.cells = cells, .clustering = 2.0, .depth = 1200.0 * um})
        .regressing(0.45 * cm / s)
        .heated(flux * cal / (s * cm2))
        .pressed(2.0 * MPa);
}

reports::Measurement measure(const Slab& slab) {
    Scene scene = slab.scene();
    scene.numerics.heat_capacity = HeatCapacity::constant_volume;
    reference::SlabConditions conditions = slab.conditions(reference::SlabModel::eulerian);
    conditions.heat_capacity = reference::HeatCapacity::constant_volume;
    const SlabProfile run = burn_to_steady(scene);
    const reference::Slab exact(conditions);
    std::vector<double> temperature, velocity;
    for (const auto& state : exact.states(run.node_y)) {
        temperature.push_back(state.temperature);
        velocity.push_back(state.velocity);
    }
    return reports::Measurement(1.0 / scene.domain.ny)
        .field("T", run.temperature, temperature, run.node_weight)
        .field("v", run.velocity, velocity, run.node_weight)
        .value("T_s - exact [K]", run.temperature.back() - exact.surface_temperature());
}

reports::Study slab_at_constant_volume(const std::string& material, double flux) {
    const auto order = expect(2.0).within(0.1).from(64);
    reports::Study study("heat-capacity, slab of " + material + " with c_v");
    study.refines("rows", {32, 64, 128, 256})
        .measure([=](int cells) { return measure(burning(material, flux, cells)); })
        .covers({term::heat_convection, term::stress_work, term::thermal_stress})
        .gate("T", Norm::L2, order, "as with c_p; the capacity is that of a cell's mean T")
        .gate("T", Norm::Linf, order, "the same at the worst node")
        .gate("v", Norm::L2, order, "v = r_b expm1(theta (T - T0)) follows T")
        .bound("T_s - exact [K]", 256, between(-0.01, 0.01),
               "a thousandth of what the capacity changes in AP, 2.8 K");
    return study;
}

std::vector<reports::Study> studies() {
    return {heated_block(), slab_at_constant_volume("AP", 200.0),
            slab_at_constant_volume("binder", 100.0)};
}

const Registered here{{.name = "heat-capacity",
                       .figure = "-",
                       .shows = "c_v beside the stress work: a heated block, a burning slab",
                       .physics = {physics::coupling, physics::slab},
                       .cost = {.verify = 15.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
