#include "cases/explore/four_solids.hpp"

namespace crawford {

namespace {

using reference::SlabModel;

constexpr double stiffening = 100.0;

Scene with_small_strain(Scene scene) {
    for (Material& material : scene.morphology.materials) {
        material.bulk_modulus *= stiffening * stiffening;
        material.shear_modulus *= stiffening * stiffening;
        material.thermal_expansion /= stiffening;
    }
    scene.surface.pressure *= stiffening;
    return scene;
}

}  // namespace

std::array<Scene, 4> four_solids(const Scene& rigid, const Scene& coupled) {
    Scene at_constant_volume = coupled;
    at_constant_volume.numerics.heat_capacity = HeatCapacity::constant_volume;
    return {rigid, with_small_strain(at_constant_volume), at_constant_volume, coupled};
}

std::array<reference::SlabConditions, 4> four_solids(const reference::SlabConditions& slab) {
    const auto of = [&](SlabModel model, reference::HeatCapacity capacity) {
        reference::SlabConditions conditions = slab;
        conditions.model = model;
        conditions.heat_capacity = capacity;
        return conditions;
    };
    constexpr auto c_p = reference::HeatCapacity::constant_pressure;
    constexpr auto c_v = reference::HeatCapacity::constant_volume;
    return {of(SlabModel::thermal, c_p), of(SlabModel::kuznetsov_stewart, c_v),
            of(SlabModel::eulerian, c_v), of(SlabModel::eulerian, c_p)};
}

Parts::Parts(const std::array<double, 4>& values)
    : whole(values[3] - values[0]),
      mechanics(values[1] - values[0]),
      stretch(values[2] - values[1]),
      twice(values[3] - values[2]) {}

}  // namespace crawford
