#include "solver/run/reduction.hpp"

#include <fmt/format.h>

#include <variant>

namespace crawford {

namespace {

Reduction one_column(const Scene& scene) {
    const double column = scene.domain.width / scene.domain.nx;
    const int columns = scene.domain.half ? scene.domain.nx / 2 : scene.domain.nx;
    Reduction reduction{
        .asked = scene,
        .scene = scene,
        .widening = Widening::of_one_column(columns, column * columns),
        .left_out = fmt::format("{} of {} columns, which are all alike", columns - 1, columns)};
    reduction.scene.domain.width = column;
    reduction.scene.domain.nx = 1;
    reduction.scene.domain.half = false;
    return reduction;
}

Reduction right_half(const Scene& scene) {
    const int columns = scene.domain.nx;
    Reduction reduction{.asked = scene,
                        .scene = scene,
                        .widening = Widening::of_right_half(columns),
                        .left_out = fmt::format(
                            "half of {} columns, which is the mirror image of the other", columns)};
    reduction.scene.domain.half = true;
    return reduction;
}

/// The half has the same patches of 2 x 2 cells as the whole.
bool has_patches_of_its_own(const Domain& domain) {
    return domain.nx >= 8 && domain.nx % 4 == 0;
}

}  // namespace

Reduction as_written(const Scene& scene) {
    return {.asked = scene, .scene = scene, .widening = {}, .left_out = ""};
}

Reduction reduced(const Scene& scene) {
    if (scene.surface.ripple) return as_written(scene);
    const Domain& domain = scene.domain;
    if (std::holds_alternative<Uniform>(scene.morphology.shape) && domain.nx > 1)
        return one_column(scene);
    if (std::holds_alternative<Sandwich>(scene.morphology.shape) && !domain.half &&
        has_patches_of_its_own(domain))
        return right_half(scene);
    return as_written(scene);
}

}  // namespace crawford
