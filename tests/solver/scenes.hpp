/// Small scenes that several solver tests start from.
#pragma once

#include <cmath>

#include "solver/mesh/grid.hpp"
#include "solver/scene/scene.hpp"

namespace crawford::testing {

inline Scene sandwich(int nx, int ny) {
    Scene scene;
    scene.domain = {.width = 240e-6, .depth = 480e-6, .nx = nx, .ny = ny};
    scene.morphology = {.shape = Sandwich{60e-6},
                        .materials = {ammonium_perchlorate(), htpb_binder()}};
    scene.surface = {.pressure = 2e6, .heat_flux = {8.368e6, 6.6944e6}};
    return scene;
}

/// One column of one material, 0.45 cm/s, no heat of reaction.
inline Scene slab(Material material, int ny) {
    material.heat_of_reaction = 0.0;
    Scene scene;
    scene.domain = {.width = 10e-6, .depth = 480e-6, .nx = 1, .ny = ny, .clustering = 0.0};
    scene.morphology.materials = {material};
    scene.physics.regression = Regression::fixed;
    scene.surface = {.pressure = 2e6, .heat_flux = {4.184e6}, .burn_rate = 0.0045};
    return scene;
}

inline Scene mechanical_only(Scene scene) {
    scene.physics = {
        .heat = false, .mechanics = true, .reference_map = false, .regression = Regression::none};
    return scene;
}

/// A surface with a slope everywhere: one wave across the window, as high as a tenth of it.
inline SurfaceField wave(const Grid& grid) {
    SurfaceField surface;
    for (int i = 0; i < grid.node_columns(); ++i)
        surface.push_back(0.1 * grid.width() *
                          std::sin(6.283185307179586 * i / grid.cell_columns()));
    return surface;
}

}  // namespace crawford::testing
