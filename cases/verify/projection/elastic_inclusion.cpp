#include "cases/verify/projection/elastic_inclusion.hpp"

#include <fmt/format.h>

#include <vector>

#include "cases/units.hpp"
#include "reference/truth_of.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

using reference::FadedInclusion;

namespace {

using namespace units;

constexpr double width = 240.0 * um;
const Vector centre(1.7 * um, -118.1 * um);  // on no grid line
constexpr double radius = 40.0 * um;

Material of(const reference::Material& moduli) {
    Material material = htpb_binder();
    material.bulk_modulus = moduli.bulk_modulus;
    material.shear_modulus = moduli.shear_modulus;
    return material;
}

ProjectionSources sources_of(const FadedInclusion& truth) {
    return {.body_force = [&truth](double x, double y, double) {
        return truth.body_force(x - centre.x(), y - centre.y());
    }};
}

}  // namespace

FadedInclusion faded_inclusion(const DiscAndMatrix& pair) {
    return {reference::CircularInclusion({.inclusion = pair.disc,
                                          .matrix = pair.matrix,
                                          .radius = radius,
                                          .far_xx = 1.0 * MPa,
                                          .far_yy = -2.0 * MPa,
                                          .far_xy = 1.5 * MPa}),
            55.0 * um, 115.0 * um};
}

Scene inclusion_scene(const DiscAndMatrix& pair, int cells) {
    Scene scene;
    scene.domain = {.width = width, .depth = width, .nx = cells, .ny = cells, .clustering = 0.0};
    scene.morphology = {
        .shape = Discs{.discs = {{centre.x(), centre.y(), radius}}, .period = 10.0 * width},
        .materials = {of(pair.disc), of(pair.matrix)}};
    scene.physics = {.heat = false, .reference_map = false, .regression = Regression::none};
    scene.bottom.support = Support::clamped;
    return scene;
}

void measure_inclusion(const Scene& scene, const FadedInclusion& truth, const std::string& suffix,
                       reports::Measurement& result) {
    Simulation simulation(scene, {{}, {}, sources_of(truth)});
    run_steps(simulation, 1);
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    std::vector<Vector> nodes, cells;
    std::vector<double> moved, stress;
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            nodes.emplace_back(grid.x(i) - centre.x(), grid.eta(j) - centre.y());
            const Vector by = state.velocity(i, j) * scene.time.step;
            moved.insert(moved.end(), by.begin(), by.end());
        }
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            cells.emplace_back(grid.x(i) + 0.5 * grid.dx() - centre.x(),
                               grid.eta(j) + 0.5 * grid.height(j) - centre.y());
            const PlaneStress mean = state.stress.mean(i, j);
            stress.insert(stress.end(), {mean.s11, mean.s22, mean.s33, mean.s12});
        }
    const auto exact = reference::truth_of(truth);
    result
        .field("displacement" + suffix, moved,
               exact.values(nodes).columns({"displacement_x", "displacement_y"}))
        .field("stress" + suffix, stress,
               exact.values(cells).columns({"stress_xx", "stress_yy", "stress_zz", "stress_xy"}));
}

std::vector<KnownValue> values_of_inclusion(const Scene& scene, const FadedInclusion& truth,
                                            const std::vector<Place>& places) {
    Simulation simulation(scene, {{}, {}, sources_of(truth)});
    run_steps(simulation, 1);
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    std::vector<KnownValue> values;
    for (const Place& place : places) {
        const NodeIndex n = node_at(grid, place);
        const double x = grid.x(n.i) - centre.x(), y = grid.eta(n.j) - centre.y();
        const auto add = [&](const char* what, const char* unit, double value, double exact) {
            values.push_back(
                {fmt::format("{} at {:g}, {:g} [{}]", what, place.across, place.up, unit), value,
                 exact});
        };
        const Vector by = state.velocity(n.i, n.j) * scene.time.step;
        add("u", "m", by.x(), truth.displacement(x, y).x());
        add("v", "m", by.y(), truth.displacement(x, y).y());
        add("sigma_22", "Pa",
            between_cells(grid, n, [&](int i, int j) { return state.stress.mean(i, j).s22; }),
            truth.stress(x, y).yy);
    }
    return values;
}

}  // namespace crawford
