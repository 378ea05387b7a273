#include "cases/verify/projection/pressed_laminate.hpp"

#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford::pressed_laminate {

using reference::ElasticLaminate;
using reference::LaminateConditions;

LaminateConditions laminate(const reference::Material& inner, double strip, double axial_strain) {
    return {.inner = inner,
            .outer = reference::ap(),
            .period = width,
            .strip = strip,
            .axial_strain = axial_strain};
}

LaminateConditions matched(double strip) {
    const auto inner = reference::balanced_strip(reference::ap(), strip, width, 0.9);
    const double stiffness = ElasticLaminate(laminate(inner, strip, 1.0)).stress(0.0).yy;
    return laminate(inner, strip, -pressure / stiffness);
}

Scene scene(const LaminateConditions& laminate, int nx, double clustering) {
    Material inner = htpb_binder();
    inner.bulk_modulus = laminate.inner.bulk_modulus;
    inner.shear_modulus = laminate.inner.shear_modulus;
    Scene scene;
    scene.domain = {
        .width = width, .depth = depth, .nx = nx, .ny = nx, .clustering = clustering, .half = true};
    scene.morphology = {.shape = Sandwich{laminate.strip},
                        .materials = {ammonium_perchlorate(), inner}};
    scene.physics = {.heat = false, .reference_map = false, .regression = Regression::none};
    scene.surface.pressure = pressure;
    return scene;
}

namespace {

/// What each layer lacks of -p_c when strained is there from the start.
void complete(StressField& stress, const ElasticLaminate& exact, const Grid& grid) {
    for (int i = 0; i < grid.cell_columns(); ++i) {
        const double s = -pressure - exact.stress(grid.x(i) + 0.5 * grid.dx()).yy;
        for (int j = 0; j < grid.rows(); ++j) {
            for (auto& point : stress.deviator) point(i, j) = {-s / 3.0, 2.0 * s / 3.0, 0.0};
            stress.pressure(i, j) = -s / 3.0;
        }
    }
}

}  // namespace

Run::Run(const LaminateConditions& laminate, const Scene& scene) {
    const ElasticLaminate exact(laminate);
    Simulation simulation(scene);
    const Grid& grid = simulation.grid();
    State start = simulation.state();
    complete(start.stress, exact, grid);
    simulation.restore(start);
    run_steps(simulation, 1);
    const State& state = simulation.state();
    axial_strain = state.velocity(0, 1).y() * scene.time.step / grid.height(0);
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            const auto truth = exact.displacement(grid.x(i), grid.eta(j) + grid.depth());
            u.push_back(state.velocity(i, j).x() * scene.time.step);
            v.push_back(state.velocity(i, j).y() * scene.time.step);
            u_exact.push_back(truth.x());
            v_exact.push_back(truth.y());
        }
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const PlaneStress mean = state.stress.mean(i, j);
            xx.push_back(mean.s11);
            yy.push_back(mean.s22);
            xx_exact.push_back(exact.stress_xx());
            yy_exact.push_back(-pressure);
        }
}

}  // namespace crawford::pressed_laminate
