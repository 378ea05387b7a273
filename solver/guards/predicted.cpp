#include "solver/guards/predicted.hpp"

#include <algorithm>

#include "solver/guards/coupling_guard.hpp"
#include "solver/guards/steady_slab.hpp"

namespace crawford {

namespace {

/// The hottest that each material gets: as it burns by itself, or the start where it does not.
double hottest(const Scene& scene, size_t material) {
    const SlabAnswer answer = steady_slab(scene, material);
    return answer.burning == Burning::steady ? answer.slab.surface_temperature
                                             : scene.bottom.temperature;
}

Guard coupling(const Scene& scene) {
    const auto& materials = scene.morphology.materials;
    Guard worst = coupling_guard(scene, materials[0], hottest(scene, 0));
    for (size_t k = 1; k < materials.size(); ++k) {
        Guard other = coupling_guard(scene, materials[k], hottest(scene, k));
        if (other.value > worst.value) worst = std::move(other);
    }
    return worst;
}

}  // namespace

Guards predicted(const Scene& scene) {
    Guards guards;
    if (scene.physics.heat && scene.physics.mechanics) guards.push_back(coupling(scene));
    return guards;
}

}  // namespace crawford
