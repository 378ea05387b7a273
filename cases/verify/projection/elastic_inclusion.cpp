#include "cases/verify/projection/elastic_inclusion.hpp"

#include <vector>

#include "cases/units.hpp"
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
    Simulation simulation(scene, {.body_force = [&](double x, double y, double) {
                              return truth.body_force(x - centre.x(), y - centre.y());
                          }});
    run_steps(simulation, 1);
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    std::vector<double> found, wanted;
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            const Vector moved = state.velocity(i, j) * scene.time.step;
            const Vector should =
                truth.displacement(grid.x(i) - centre.x(), grid.eta(j) - centre.y());
            for (int k = 0; k < 2; ++k) {
                found.push_back(moved[k]);
                wanted.push_back(should[k]);
            }
        }
    std::vector<double> stress, stress_wanted;
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const PlaneStress mean = state.stress.mean(i, j);
            const auto should = truth.stress(grid.x(i) + 0.5 * grid.dx() - centre.x(),
                                             grid.eta(j) + 0.5 * grid.height(j) - centre.y());
            stress.insert(stress.end(), {mean.s11, mean.s22, mean.s33, mean.s12});
            stress_wanted.insert(stress_wanted.end(), {should.xx, should.yy, should.zz, should.xy});
        }
    result.field("displacement" + suffix, found, wanted)
        .field("stress" + suffix, stress, stress_wanted);
}

}  // namespace crawford
