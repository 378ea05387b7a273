#include "cases/scene_text.hpp"

#include <fmt/format.h>

#include "cases/units.hpp"

namespace crawford {

std::string grid_text(const Scene& scene) {
    const Domain& d = scene.domain;
    return fmt::format("{} × {}, clustering {}{}", d.nx, d.ny, d.clustering,
                       d.half ? ", half modelled" : "");
}

std::string step_text(const Scene& scene) {
    return fmt::format("{:g} µs, t = {:g} s", scene.time.step / units::us, scene.time.end);
}

}  // namespace crawford
