#include "cases/explore/extreme_scenes.hpp"

#include "cases/units.hpp"

namespace crawford {

using namespace units;

const std::vector<Material>& propellant() {
    static const std::vector<Material> both{ammonium_perchlorate(), htpb_binder()};
    return both;
}

Scene burning_slab(const Material& material, double flux) {
    Scene scene;
    scene.domain = {.width = 5.0 * um, .depth = 480.0 * um, .nx = 1, .ny = 96, .clustering = 2.0};
    scene.morphology.materials = {material};
    scene.physics = {.mechanics = false, .reference_map = false};
    scene.surface = {.pressure = 2.0 * MPa, .heat_flux = {flux * flux_into_ap}};
    scene.time = {.step = 40.0 * us, .end = 40.0 * ms};
    return scene;
}

Scene half_sandwich(int columns, double flux) {
    Scene scene = burning_slab(ammonium_perchlorate(), flux);
    scene.domain = {.width = 240.0 * um,
                    .depth = 480.0 * um,
                    .nx = columns,
                    .ny = 48,
                    .clustering = 2.0,
                    .half = true};
    scene.morphology = {.shape = Sandwich{60.0 * um}, .materials = propellant()};
    scene.surface.heat_flux.push_back(0.8 * flux * flux_into_ap);
    scene.time.end = 20.0 * ms;
    return scene;
}

}  // namespace crawford
