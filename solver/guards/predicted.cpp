#include "solver/guards/predicted.hpp"

#include <algorithm>
#include <cmath>

#include "solver/guards/burning_guards.hpp"
#include "solver/guards/coupling_guard.hpp"
#include "solver/guards/grid_guards.hpp"
#include "solver/guards/steady_slab.hpp"
#include "solver/scene/defaults.hpp"

namespace crawford {

namespace {

/// A material of the scene and how it burns by itself.
struct Part {
    size_t number;
    const Material& material;
    SlabAnswer answer;

    bool burns() const { return answer.burning == Burning::steady; }
    double burn_rate() const { return answer.slab.burn_rate; }
};

std::vector<Part> parts_of(const Scene& scene) {
    std::vector<Part> parts;
    for (size_t k = 0; k < scene.morphology.materials.size(); ++k)
        parts.push_back({k, scene.morphology.materials[k], steady_slab(scene, k)});
    return parts;
}

/// Of the middle of the uppermost row, where heat and stress meet [K]: cooler than the surface by what a
/// layer of exp(r_b y/D) loses over half a row.
double hottest_cell(const Scene& scene, const Grid& grid, const Part& part) {
    const double cold = scene.bottom.temperature;
    if (!part.burns()) return cold;
    const double depth = 0.5 * grid.height(grid.rows() - 1);
    return cold + (part.answer.slab.surface_temperature - cold) *
                      std::exp(-depth * part.burn_rate() / part.material.diffusivity());
}

/// Keeps of each name the guard that is nearest its limit, or beyond it.
void add_worst(Guards& guards, Guard guard) {
    const auto same = std::ranges::find(guards, guard.name, &Guard::name);
    if (same == guards.end())
        guards.push_back(std::move(guard));
    else if (is_worse(guard, *same))
        *same = std::move(guard);
}

/// As it is, whatever its limit: narrow strips are less steep than what is predicted of wide ones.
Guard told(Guard guard) {
    guard.beyond = Beyond::nothing;
    guard.text.clear();
    return guard;
}

/// \returns whether it burns steadily.
bool add_burning(Guards& guards, const Scene& scene, const Grid& grid, const Part& part) {
    const double rate = part.burn_rate();
    if (part.material.heat_of_reaction > 0.0 && scene.physics.regression == Regression::pyrolysis) {
        Guard swings = onset(scene, part.material, part.answer.slab);
        const bool steady = swings.beyond == Beyond::nothing;
        add_worst(guards, std::move(swings));
        if (!steady) return false;  // what is steady is then never seen
    }
    add_worst(guards, cell_peclet(grid, part.material, rate));
    add_worst(guards, undershoot(deepest_undershoot(scene, grid, part.material, part.answer.slab)));
    add_worst(guards, front_coupling(scene, grid, part.material, part.answer.slab));
    if (scene.physics.regression == Regression::pyrolysis)
        add_worst(guards, alternation(0.0));  // or front_coupling refuses it
    if (grid.cell_columns() > 1)
        add_worst(guards, predicted_front_crossing(scene, grid, part.material, part.answer.slab));
    if (scene.physics.mechanics && grid.cell_columns() > 1)
        // A slab expands towards the surface alone; beside another material also sideways.
        add_worst(guards, crossing_x(speed_of_expansion(scene, part.material, part.answer.slab) *
                                     scene.time.mechanics_step() / narrowest_column(grid)));
    return true;
}

void add_coupling(Guards& guards, const Scene& scene, const Material& material, double hottest) {
    if (scene.numerics.heat_capacity == HeatCapacity::constant_volume)
        add_worst(guards, heat_capacity_guard(scene, material, hottest));
    add_worst(guards, coupling_guard(scene, material, hottest));
    add_worst(guards, expansion_guard(scene, material, hottest));
}

/// What each number by itself says.
Guards numbers_of(const Scene& scene) {
    const Grid grid(scene.domain, strip_side(scene));
    Guards guards;
    double fastest = scene.physics.regression == Regression::fixed ? scene.surface.burn_rate : 0.0;
    const std::vector<Part> parts = parts_of(scene);
    const Part* leader = nullptr;  // what burns fastest, and first
    for (const Part& part : parts) {
        if (auto without = burning_solution(scene, part.number, part.answer))
            add_worst(guards, std::move(*without));
        if (scene.physics.heat && scene.physics.mechanics)
            add_coupling(guards, scene, part.material, hottest_cell(scene, grid, part));
        if (scene.physics.heat) {
            add_worst(guards, fourier(scene, grid, part.material));
            add_worst(guards, relaxation(scene, grid, part.material));
        }
        if (scene.physics.mechanics) add_worst(guards, pressing(scene, grid, part.material));
        if (part.burns() && add_burning(guards, scene, grid, part)) {
            if (part.burn_rate() > fastest) leader = &part;
            fastest = std::max(fastest, part.burn_rate());
        }
    }
    if (leader != nullptr && scene.physics.regression == Regression::pyrolysis)
        guards.push_back(ignition(scene, grid, leader->material, leader->answer.slab,
                                  scene.surface.heat_flux[leader->number]));
    if (fastest > 0.0) {
        if (auto columns = columns_in_layer(scene, fastest)) guards.push_back(std::move(*columns));
        // The slower part is carried along: the faster side leads.
        if (scene.physics.heat)
            for (const Material& material : scene.morphology.materials)
                add_worst(guards, layers_in_window(scene, material, fastest));
        guards.push_back(predicted_crossing_y(scene, grid, fastest));
        if (grid.cell_columns() == 1) return guards;
        for (const Part& part : parts)
            if (parts.size() > 1 && part.burns())
                add_worst(guards, column_peclet(scene, grid, part.material,
                                                {part.answer.slab.surface_temperature, fastest}));
        if (scene.physics.regression == Regression::pyrolysis)
            guards.push_back(told(slope(predicted_slope(scene, fastest))));
    }
    return guards;
}

}  // namespace

Guards predicted(const Scene& scene) {
    Guards guards = numbers_of(scene);
    advise_step(guards);
    return guards;
}

}  // namespace crawford
