#include "cases/verify/coupled/heated_block.hpp"

#include "cases/units.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;

/// In which heat goes some 15 um into the binder and 20 um into AP, from a bottom that is held cold
/// 240 um below the surface where T is read.
constexpr double duration = 1.0 * ms;

Scene block(const Material& material, HeatCapacity capacity, int steps) {
    Scene scene;
    scene.domain = {.width = 10.0 * um, .depth = 240.0 * um, .nx = 1, .ny = 24, .clustering = 0.0};
    scene.morphology.materials = {material};
    scene.physics = {.reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {0.0};
    scene.numerics.heat_capacity = capacity;
    scene.time.step = duration / steps;
    scene.time.scheme = Stepping::bdf2;
    return scene;
}

}  // namespace

Heating heat_evenly(const Material& material, HeatCapacity capacity, double heat, int steps) {
    const Scene scene = block(material, capacity, steps);
    // Gently at first: a solid at rest knows nothing of the stress work of heat that is there at
    // once.
    Sources sources;
    sources.heat = [heat](double, double, double t) {
        return 2.0 * heat * t / (duration * duration);
    };
    Simulation simulation(scene, sources);
    Heating heating;
    const Observer note = [&](const Simulation& now, double) {
        const double part = double(now.state().step) / steps;
        heating.heat.push_back(heat * part * part);
        heating.temperature.push_back(now.state().temperature(0, scene.domain.ny));
    };
    run_steps(simulation, steps, {note});
    return heating;
}

}  // namespace crawford
