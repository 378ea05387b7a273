/// # Inclusion: what does an interface cost that runs across the grid as it likes?
///
/// One disc in a matrix under shear and pressure from far away has an exact solution
/// (reference/circular_inclusion.hpp). It is made to fit a window: near the disc it is the exact
/// field, further out it fades smoothly to nothing and a body force holds it
/// (reference/faded_inclusion.hpp), so the window's sides, its bottom and its surface see neither
/// displacement nor traction. One step of the projection from rest should find it.
///
/// The interface cuts cells. A cut cell holds the harmonic means of K and mu, which are right for a
/// layer that is loaded across and too soft for one that is strained along. The modulus is wrong by
/// a fixed amount in a ring of width h about the circle, on one side always, so nothing cancels:
/// displacements are of order 1 (an error of the modulus on an area h acts like one), stress of
/// order 1 in L1 and 1/2 in L2, and nothing converges in the cut cells themselves. That is what an
/// unfitted interface without enrichment can do; with one material the same run is of order 2,
/// which shows that the rest of the error is the ring's.
///
/// The matrix is AP and the disc binder (K/mu = 4268). The other way round the fading would
/// compress the binder of the matrix: pressures a thousand times the load, held by the body force,
/// whose error of order 2 (12 % of the displacement on 256 cells) hides the ring's.

#include <string>
#include <vector>

#include "cases/catalogue/registry.hpp"
#include "cases/catalogue/terms.hpp"
#include "cases/catalogue/units.hpp"
#include "reference/faded_inclusion.hpp"
#include "solver/simulation/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::FadedInclusion;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
const Vector centre(1.7 * um, -118.1 * um);  // on no grid line
constexpr double radius = 40.0 * um;

struct Pair {
    reference::Material inclusion, matrix;
};

FadedInclusion exact(const Pair& pair) {
    return {reference::CircularInclusion({.inclusion = pair.inclusion,
                                          .matrix = pair.matrix,
                                          .radius = radius,
                                          .far_xx = 1.0 * MPa,
                                          .far_yy = -2.0 * MPa,
                                          .far_xy = 1.5 * MPa}),
            55.0 * um, 115.0 * um};
}

Material of(const reference::Material& moduli) {
    Material material = htpb_binder();
    material.bulk_modulus = moduli.bulk_modulus;
    material.shear_modulus = moduli.shear_modulus;
    return material;
}

Scene scene(const Pair& pair, int nx) {
    Scene scene;
    scene.domain = {.width = width, .depth = width, .nx = nx, .ny = nx, .clustering = 0.0};
    scene.morphology = {
        .shape = Discs{.discs = {{centre.x(), centre.y(), radius}}, .period = 10.0 * width},
        .materials = {of(pair.inclusion), of(pair.matrix)}};
    scene.physics = {.heat = false, .reference_map = false, .regression = Regression::none};
    scene.bottom.support = Support::clamped;
    return scene;
}

reports::Measurement measure(const Pair& pair, int nx) {
    const FadedInclusion truth = exact(pair);
    Simulation simulation(scene(pair, nx), {.body_force = [&](double x, double y, double) {
                              return truth.body_force(x - centre.x(), y - centre.y());
                          }});
    simulation.step();
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    std::vector<double> found, wanted;
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            const Vector moved = state.velocity(i, j) * simulation.scene().time.step;
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
    reports::Measurement result(1.0 / nx);
    result.field("displacement", found, wanted).field("stress", stress, stress_wanted);
    return result;
}

reports::Study study(const std::string& name, const Pair& pair) {
    reports::Study study("projection-inclusion, " + name);
    study.measure([pair](int nx) { return measure(pair, nx); })
        .covers({term::elasticity, term::equilibrium, term::elastic_interface});
    return study;
}

std::vector<reports::Study> studies() {
    using reference::ap;
    using reference::binder;
    const auto smooth = expect(2.0).within(0.15);
    auto none = study("no interface", {ap(), ap()});
    none.grids({32, 64, 128})
        .gate("displacement", Norm::L2, smooth, "bilinear elements on a smooth field")
        .gate("displacement", Norm::Linf, smooth, "the same at the worst node")
        .gate("stress", Norm::L2, smooth, "centres of cells are where the gradient is of order 2");
    auto soft = study("binder in AP", {binder(), ap()});
    soft.grids({32, 64, 128, 256})
        .gate("displacement", Norm::L2, expect(1.0).within(0.1),
              "moduli wrong by a fixed amount in a ring of width h")
        .gate("displacement", Norm::Linf, expect(1.0).within(0.15),
              "the same; the worst node depends on how the circle cuts its cell")
        .gate("stress", Norm::L1, expect(1.0).within(0.15),
              "wrong by a fixed amount on an area h, by h elsewhere")
        .gate("stress", Norm::L2, expect(0.5).within(0.1), "the root of that area");
    return {none, soft};
}

const Registered here{{.name = "projection-inclusion",
                       .figure = "-",
                       .shows = "one step around a disc against the exact inclusion",
                       .cost = {.verify = 10.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
