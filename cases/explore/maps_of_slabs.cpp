#include <fmt/format.h>

#include <algorithm>

#include "cases/explore/extreme_axes.hpp"
#include "cases/explore/extreme_maps.hpp"
#include "cases/explore/extreme_scenes.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;
using namespace extreme;

const ExtremeLimit layers{"layers_in_window", 5.0, "5 layers in the window", true};
const ExtremeLimit peclet{"cell_peclet", 2.0, "cell Peclet number 2"};

ExtremeLimit front_coupling(double at) {
    return {"front_coupling", at, fmt::format("front_coupling {:.3g}", at)};
}

Scene with(Stepping scheme, Scene scene) {
    scene.time.scheme = scheme;
    return scene;
}

Scene coupled(Scene scene) {
    scene.physics.mechanics = true;
    scene.domain.ny = 48;
    return scene;
}

/// A hotter flame burns as far in less time; some steps must there be.
void burn_as_far(Scene& scene) {
    const double flux = scene.surface.heat_flux.front() / flux_into_ap;
    constexpr double fewest_steps = 20.0;
    scene.time.end = std::max(40.0 * ms / flux, fewest_steps * scene.time.step);
}

/// From rest: the first fifty steps.
void fifty_steps(Scene& scene) {
    scene.time.end = std::max(5.0 * ms, 50.0 * scene.time.step);
}

ExtremeAxis temperature_of_the_bottom() {
    return {.key = "bottom.temperature",
            .unit = "K",
            .scale = 1.0,
            .label = "T of the bottom / K",
            .values = {1.0, 10.0, 100.0, 200.0, 300.0, 500.0, 700.0, 900.0},
            .put = [](Scene& scene, double t) { scene.bottom.temperature = t; },
            .is_logarithmic = false};
}

ExtremeAxis heat_of_reaction() {
    return {.key = "materials.AP.heat_of_reaction",
            .unit = "MJ/kg",
            .scale = 1e6,
            .label = "heat of the surface's reaction / (MJ/kg)",
            .values = {-1.0, -0.5, -0.2, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8},
            .put = [](Scene& scene,
                      double q) { scene.morphology.materials.front().heat_of_reaction = q; },
            .is_logarithmic = false};
}

ExtremeAxis moduli() {
    return {.key = "bulk and shear modulus",
            .unit = "-",
            .scale = 1.0,
            .label = "K and μ over the paper's",
            .values = {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0},
            .put = [](Scene& scene, double times) {
                Material& m = scene.morphology.materials.front();
                m.bulk_modulus *= times;
                m.shear_modulus *= times;
            }};
}

ExtremeAxis accuracy() {
    return {.key = "time.accuracy",
            .unit = "-",
            .scale = 1.0,
            .label = "time.accuracy",
            .values = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
            .put = [](Scene& scene, double accuracy) {
                scene.time.accuracy = accuracy;
                scene.time.step = first_chosen_step;
            }};
}

}  // namespace

std::vector<ExtremeMap> maps_of_slabs() {
    const Material ap = ammonium_perchlorate();
    const Material binder = htpb_binder();
    const ExtremeLimit followed = front_coupling(0.5), alternating = front_coupling(2.0);
    const auto conduction = &Material::thermal_conductivity;
    return {{"a",
             "slab of AP, euler",
             burning_slab(ap, 1.0),
             flux({0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}),
             step({10, 20, 80, 160, 320, 640, 1280, 2560}),
             {followed, alternating, layers},
             burn_as_far},
            {"b",
             "slab of binder, bdf2",
             with(Stepping::bdf2, burning_slab(binder, 1.0)),
             flux({0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0}),
             step({10, 20, 80, 160, 320, 640, 1280, 2560}),
             {followed, front_coupling(4.0 / 3.0), layers},
             burn_as_far},
            {"c",
             "slab of AP, window",
             burning_slab(ap, 1.0),
             depth({25, 50, 75, 100, 150, 200, 480, 1000, 2000}),
             rows({3, 4, 8, 16, 32, 64, 128}),
             {layers, peclet}},
            {"d",
             "slab of binder with stress, ways to couple",
             coupled(burning_slab(binder, 1.0)),
             property(&Material::thermal_expansion, "materials.binder.thermal_expansion",
                      "thermal expansion over the paper's",
                      {0.1, 0.3, 0.5, 0.7, 1.0, 1.4, 1.8, 2.2, 3.0}),
             couplings(),
             {{"coupling", {}, "limit of the coupling"}}},
            {"e",
             "slab of AP, exothermic surface",
             burning_slab(ap, 1.0),
             heat_of_reaction(),
             flux({0.25, 0.5, 1.0, 2.0, 4.0}),
             {{"onset", {}, "onset"}},
             burn_as_far},
            {"f",
             "slab of AP, law and cold",
             burning_slab(ap, 1.0),
             property(&Material::activation_temperature, "materials.AP.activation_temperature",
                      "activation temperature over the paper's",
                      {0.2, 0.3, 0.5, 0.7, 0.85, 1.0, 1.4, 2.0, 4.0}),
             temperature_of_the_bottom(),
             {layers, followed}},
            {"g",
             "slab of AP, light and heavy",
             burning_slab(ap, 1.0),
             property(&Material::density, "materials.AP.density", "density over the paper's",
                      {1e-3, 1e-2, 0.1, 0.3, 1.0, 3.0, 10.0}),
             step({10, 20, 80, 320, 1000, 2000}),
             {followed, alternating, layers}},
            {"h",
             "slab of AP with stress, clustered rows",
             coupled(burning_slab(ap, 1.0)),
             clustering({0, 1, 2, 3, 4, 5, 6}),
             step({10, 20, 80, 160, 320, 640, 1280}),
             {{"crossing_y", 1.0, "a row crossed in a step"}}},
            {"i",
             "slab of AP, the first steps",
             burning_slab(ap, 1.0),
             clustering({0, 1, 2, 3, 4, 5, 6}),
             step({10, 20, 80, 160, 320, 640, 1280}),
             {{"fourier", 9.5, "fourier 9.5"}, followed, {"ignition", {}, "ignition 2 %"}},
             fifty_steps},
            {"j",
             "slab of AP with stress, pressed",
             coupled(burning_slab(ap, 1.0)),
             pressure({0.1, 1, 10, 100, 1000, 10000}),
             moduli(),
             {{"pressing", {}, "squeezed by a tenth"}}},
            {"k",
             "slab of AP, conductivity and capacity",
             burning_slab(ap, 1.0),
             property(conduction, "materials.AP.thermal_conductivity",
                      "conductivity over the paper's", {0.01, 0.1, 0.3, 1.0, 3.0, 10.0}),
             property(&Material::specific_heat, "materials.AP.specific_heat",
                      "specific heat over the paper's", {0.1, 0.3, 1.0, 3.0, 10.0}),
             {layers, peclet, followed}},
            {"l",
             "slab of AP, steps chosen",
             burning_slab(ap, 1.0),
             flux({0.2, 0.5, 1.0, 2.0, 5.0, 10.0}),
             accuracy(),
             {},
             burn_as_far}};
}

}  // namespace crawford
