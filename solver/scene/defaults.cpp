#include "solver/scene/defaults.hpp"

#include <variant>

namespace crawford {

double viscous_time(const Scene& scene) {
    if (scene.numerics.viscous_time) return *scene.numerics.viscous_time;
    const bool has_corners = !std::holds_alternative<Uniform>(scene.morphology.shape);
    const bool burns = scene.physics.regression != Regression::none;
    return has_corners && burns ? viscous_time_at_a_corner : 0.0;
}

double strip_side(const Scene& scene) {
    const auto* sandwich = std::get_if<Sandwich>(&scene.morphology.shape);
    return sandwich ? 0.5 * sandwich->strip : 0.0;
}

Scene resolved(Scene scene) {
    scene.numerics.viscous_time = viscous_time(scene);
    return scene;
}

}  // namespace crawford
