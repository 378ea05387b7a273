#include <algorithm>

#include "base/source_tree.hpp"
#include "cases/explore/extreme_axes.hpp"
#include "cases/explore/extreme_maps.hpp"
#include "cases/explore/extreme_scenes.hpp"
#include "cases/units.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

using namespace units;
using namespace extreme;

const ExtremeLimit followed{"front_coupling", 0.5, "front_coupling 0.5"};
const ExtremeLimit alternating{"front_coupling", 2.0, "front_coupling 2"};
const ExtremeLimit peclet{"cell_peclet", 2.0, "cell Peclet number 2"};
const ExtremeLimit layers{"layers_in_window", 5.0, "5 layers in the window", true};
const ExtremeLimit crossing{"crossing_y", 1.0, "a row crossed in a step"};

Scene coupled(int columns, int rows) {
    Scene scene = half_sandwich(columns, 1.0);
    scene.physics.mechanics = true;
    scene.physics.reference_map = true;
    scene.domain.ny = rows;
    scene.time.end = 10.0 * ms;
    return scene;
}

/// The paper's pack on a coarse grid, for the first 10 ms.
Scene pack(bool mechanics) {
    Scene scene = read_scene(source_path("cases/scenes/pack.toml"));
    scene.domain.ny = 48;
    scene.physics.mechanics = mechanics;
    scene.physics.reference_map = false;
    scene.time.end = 10.0 * ms;
    return scene;
}

ExtremeAxis strip(std::vector<double> values) {
    return {.key = "morphology.strip",
            .unit = "um",
            .scale = um,
            .label = "strip of binder / µm",
            .values = std::move(values),
            .put = [](Scene& scene, double width) {
                std::get<Sandwich>(scene.morphology.shape).strip = width;
            }};
}

ExtremeAxis shear_of_binder() {
    return {.key = "shear modulus of binder over that of AP",
            .unit = "-",
            .scale = 1.0,
            .label = "μ of binder over that of AP",
            .values = {1e-8, 1e-6, 1e-4, 1e-2, 1.0},
            .put = [](Scene& scene, double ratio) {
                auto& materials = scene.morphology.materials;
                materials[1].shear_modulus = ratio * materials[0].shear_modulus;
            }};
}

ExtremeAxis clustering_x() {
    return {.key = "domain.clustering_x",
            .unit = "-",
            .scale = 1.0,
            .label = "clustering of columns",
            .values = {0, 1, 2, 3, 4},
            .put = [](Scene& scene, double c) { scene.domain.clustering_x = c; },
            .is_logarithmic = false};
}

void burn_as_far(Scene& scene) {
    const double flux = scene.surface.heat_flux.front() / flux_into_ap;
    constexpr double fewest_steps = 20.0;
    scene.time.end = std::max(20.0 * ms / flux, fewest_steps * scene.time.step);
}

}  // namespace

std::vector<ExtremeMap> maps_of_sandwiches() {
    const auto expansion = &Material::thermal_expansion;
    return {{"m",
             "rigid sandwich, grid",
             half_sandwich(32, 1.0),
             columns({8, 16, 32, 64}),
             rows({4, 8, 16, 32, 64}),
             {peclet, {"columns_in_layer", 3.0, "3 columns in a layer", true}}},
            {"n",
             "rigid sandwich, flux",
             half_sandwich(32, 1.0),
             flux({0.3, 0.5, 1.0, 2.0, 4.0}),
             step({20, 80, 160, 320, 640, 1280}),
             {followed, alternating, layers},
             burn_as_far},
            {"o",
             "rigid sandwich, strip and slow binder",
             half_sandwich(48, 1.0),
             strip({5, 20, 60, 120, 220}),
             property(&Material::pyrolysis_prefactor, "materials.binder.pyrolysis_prefactor",
                      "prefactor of binder over the paper's", {1e-3, 1e-2, 0.1, 1.0, 10.0}),
             {{"slope", 3.0, "slope 3"}, {"columns_in_layer", 3.0, "3 columns in a layer", true}}},
            {"p", "sandwich with stress, moduli of binder", coupled(24, 24), shear_of_binder(),
             property(&Material::bulk_modulus, "materials.binder.bulk_modulus",
                      "K of binder over the paper's", {1e-3, 0.1, 1.0, 10.0, 1000.0})},
            {"q",
             "sandwich with stress, ways to couple",
             coupled(16, 24),
             property(expansion, "materials.binder.thermal_expansion",
                      "thermal expansion of binder over the paper's", {0.3, 0.7, 1.0, 1.4, 2.2}),
             couplings(),
             {{"coupling", {}, "limit of the coupling"}}},
            {"r",
             "sandwich with stress, pressure",
             coupled(16, 24),
             pressure({0.1, 2, 30, 100, 1000}),
             step({20, 80, 160, 320, 640}),
             {crossing, {"pressing", {}, "squeezed by a tenth"}}},
            {"s",
             "sandwich with stress, clustered grid",
             coupled(16, 24),
             clustering_x(),
             clustering({0, 1, 2, 3, 4}),
             {crossing}},
            {"t", "pack, rigid", pack(false), columns({30, 60}), step({25, 100, 400}), {followed}},
            {"u", "pack with stress", pack(true), columns({16, 30}), step({100, 200}), {crossing}}};
}

}  // namespace crawford
