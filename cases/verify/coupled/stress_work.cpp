/// # Stress work: do heat and stress feed each other as thermodynamics says?
///
/// A column that cannot widen is heated evenly, so fast that conduction does not count, or pressed.
/// Heated, it rises, and that takes heat; pressed, it warms. Uniform as it stays, both have a
/// closed form (reference/adiabatic_column.hpp), in which every reading has its place: beta = 3
/// alpha K or alpha K, separately for the stress and for its work, and the capacity at constant
/// pressure or at constant volume. The whole solver runs: heat, stress, projection.
///
/// Nothing varies in space but a layer of 31 um above the bottom, which is held cold, 240 um below
/// the surface where T and sigma_11 are read. What is left is the error in time; a "grid" is a
/// number of steps. The paper's step lags and is of first order, the one that looks back two steps
/// of second. Heating begins gently, as t: a solid at rest knows nothing of the stress work of a
/// source that is there at once, and any step would err by one whole step of it.

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/adiabatic_column.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::expect;
using reports::Norm;

constexpr double duration = 1.0 * ms;
constexpr double heat = 200.0 * MPa;  ///< J/m^3: some 100 K
constexpr double pressure = 200.0 * MPa;

/// A block of binder that does not burn, with grid and readings.
Scene binder(Coupling coupling) {
    Scene scene;
    scene.domain = {.width = 10.0 * um, .depth = 240.0 * um, .nx = 1, .ny = 24, .clustering = 0.0};
    scene.morphology.materials = {htpb_binder()};
    scene.physics = {.reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {0.0};
    scene.numerics.coupling = coupling;
    return scene;
}

double beta(ThermalStress reading) {
    const reference::Material m = reference::binder();
    const double factor = reading == ThermalStress::three_alpha_bulk ? 3.0 : 1.0;
    return factor * m.thermal_expansion * m.bulk_modulus;
}

reference::AdiabaticColumn truth(const Numerics& readings) {
    const reference::Material m = reference::binder();
    const double work = beta(readings.stress_work);
    const bool constant_volume = readings.heat_capacity == HeatCapacity::constant_volume;
    return reference::AdiabaticColumn(
        {.capacity = m.density * m.specific_heat,
         .capacity_slope = constant_volume ? work * work / m.bulk_modulus : 0.0,
         .stress_work = work,
         .thermal_stress = beta(readings.thermal_stress),
         .lame = m.lame(),
         .shear_modulus = m.shear_modulus,
         .cold_temperature = 300.0});
}

reports::Measurement run(Scene scene, const Sources& sources, int steps, double temperature,
                         double lateral_stress) {
    scene.time.step = duration / steps;
    Simulation simulation(scene, sources);
    run_steps(simulation, steps);
    const State& state = simulation.state();
    const int top = scene.domain.ny;
    return reports::Measurement(1.0 / steps)
        .value("T", state.temperature(0, top), temperature)
        .value("sigma_11", state.stress.mean(0, top - 1).s11, lateral_stress);
}

reports::Measurement heated(const Scene& scene, int steps) {
    const auto column = truth(scene.numerics);
    const double hot = column.heated(heat);
    Sources sources;
    sources.heat = [](double, double, double t) { return 2.0 * heat * t / (duration * duration); };
    return run(scene, sources, steps, hot, column.lateral_stress(hot, 0.0));
}

reports::Measurement pressed(const Scene& scene, int steps) {
    const auto column = truth(scene.numerics);
    const double warm = column.pressed(pressure);
    Sources sources;
    sources.traction = [](double, double, double t) {
        return Vector{0.0, -pressure * t / duration};
    };
    return run(scene, sources, steps, warm, column.lateral_stress(warm, pressure));
}

reports::Study study(const std::string& what,
                     reports::Measurement (*measure)(const Scene& scene, int steps),
                     const Scene& scene) {
    const bool two_steps = scene.time.scheme == Stepping::bdf2;
    const double order = two_steps ? 2.0 : 1.0;
    const std::string reason =
        two_steps ? "nothing lags: extrapolated from two steps" : "the stress work lags by a step";
    reports::Study study("stress-work, " + what);
    study.refines("steps", {64, 128, 256, 512})
        .measure([=](int steps) { return measure(scene, steps); })
        .covers({term::stress_work, term::thermal_stress, term::heat_storage, term::elasticity,
                 term::traction, term::time_step})
        .gate("T", Norm::magnitude, expect(order).within(0.1), reason)
        .gate("sigma_11", Norm::magnitude, expect(order).within(0.1), "follows T; " + reason);
    return study;
}

std::vector<reports::Study> studies() {
    const Scene split = binder(Coupling::adiabatic);
    const Scene lagged = binder(Coupling::lagged);
    Scene alpha_k = split;
    alpha_k.numerics.stress_work = alpha_k.numerics.thermal_stress = ThermalStress::alpha_bulk;
    Scene mixed = split;
    mixed.numerics.stress_work = ThermalStress::alpha_bulk;
    Scene constant_volume = split;
    constant_volume.numerics.heat_capacity = HeatCapacity::constant_volume;
    Scene two_steps = lagged;
    two_steps.time.scheme = Stepping::bdf2;
    return {study("heated, split", heated, split),
            study("heated, lagged", heated, lagged),
            study("heated, alpha K", heated, alpha_k),
            study("heated, alpha K only in the work", heated, mixed),
            study("heated, constant volume", heated, constant_volume),
            study("heated, two steps back", heated, two_steps),
            study("pressed, split", pressed, split),
            study("pressed, lagged", pressed, lagged)};
}

const Registered here{{.name = "stress-work",
                       .figure = "-",
                       .shows = "a confined column, heated or pressed, in closed form",
                       .cost = {.verify = 2.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
