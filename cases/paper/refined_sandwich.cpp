#include "cases/paper/refined_sandwich.hpp"

#include <fmt/format.h>

namespace crawford {

namespace {

std::vector<int> columns(Fidelity fidelity) {
    switch (fidelity) {
        case Fidelity::draft:
            return {16, 32, 64};
        case Fidelity::paper:
            return {32, 64, 128, 256};
        default:
            return {32, 64, 128, 256, 512};
    }
}

}  // namespace

std::vector<Scene> refined_scenes(Fidelity fidelity, Front front) {
    std::vector<Scene> scenes;
    for (const int nx : columns(fidelity)) {
        Scene& scene = scenes.emplace_back(burning_sandwich(fidelity, true));
        scene.domain.nx = nx;
        scene.numerics.front = front;
        if (fidelity == Fidelity::draft) scene.time.end = 0.04;
    }
    return scenes;
}

std::vector<std::shared_ptr<const Burn>> refined_sandwich(const Request& request, Front front) {
    std::vector<std::shared_ptr<const Burn>> burns;
    for (const Scene& scene : refined_scenes(request.fidelity, front))
        burns.push_back(kept_burn(scene, request));
    return burns;
}

std::string grids_text(const std::vector<std::shared_ptr<const Burn>>& burns) {
    std::string text;
    for (size_t k = 0; k + 1 < burns.size(); ++k)
        text += fmt::format("{}, ", burns[k]->scene.domain.nx);
    return text + grid_text(burns.back()->scene);
}

}  // namespace crawford
