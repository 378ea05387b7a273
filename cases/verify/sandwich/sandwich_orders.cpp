/// # Mechanical sandwich: which order can a uniform grid have beside a singular corner?
///
/// Bilinear elements are of order 2 where the solution is smooth. In the sandwich it is not: where
/// interface and surface meet, displacement goes as r^lambda, lambda = 0.59502
/// (reference/williams_corner.hpp; the case "corner" reads it from the stress). What that does to a
/// uniform grid is known, and is asked of the solver here, against reference/elastic_sandwich.hpp.
///
/// - At the corner, in the first few cells, error scales as the solution does: displacement
///   h^lambda and, since that is the largest error anywhere, order lambda in Linf over the whole
///   field. Stress there is wrong by h^(lambda - 1): its largest error grows without end, by 1.32 a
///   halving, and its L2 norm, over an area h^2, is of order lambda.
/// - Away from the corner, r > 30 um, elements are of order 2 again but for what the corner sends
///   out: it acts as a dipole whose strength is wrong by h^(2 lambda), the energy of the error.
///   Such pollution is of order 1.19 however far one goes, and no uniform grid is rid of it. Sooner
///   or later it is all there is: u, whose own error is small, shows it from 128 columns on, v
///   still hides it under its h^2, stress is between, and falls from grid to grid as it must.
/// - Successive differences, at nodes and in cells that all grids share, need no truth. But points
///   that stay where they are leave the corner's few cells as the grid is refined. The differences
///   of v are of order 2.0 over the whole field, whose worst node converges at 0.6: an order read
///   from differences is not wrong, it is an order of something else, and never of a peak.
///
/// The bottom slides (with a clamped one, where the interface ends on it, is a second singular
/// corner), and the window is 240 um deep.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/elastic_sandwich.hpp"
#include "reference/williams_corner.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::expect;
using reports::Norm;

constexpr double pressure = 2.0 * MPa;
constexpr double interface = 30.0 * um;
constexpr double depth = 240.0 * um;
constexpr double far = 30.0 * um;  // from the corner
constexpr int coarsest = 64;

Scene pressed(int nx) {
    Scene scene = sandwich({"domain.clustering=0", "domain.depth=240 um"});
    scene.domain.nx = nx;
    scene.domain.ny = nx;
    scene.physics = {.heat = false, .reference_map = false, .regression = Regression::none};
    scene.numerics.viscous_time.reset();  // it follows what burns
    return scene;
}

reference::ElasticSandwich exact() {
    reference::SandwichGeometry geometry = reference::paper_sandwich();
    geometry.depth = depth;
    // 8 layers, each a quarter of the last: the corner is resolved to 0.5 nm.
    return {geometry, pressure, reference::Support::roller, {.layers = 8, .ratio = 0.25}};
}

bool is_far(double x, double y) {
    return std::hypot(x - interface, y) >= far;
}

/// A field, what it should be, and what of both is far from the corner.
class Compared {
public:
    void add(double x, double y, double found, double truth) {
        all_.found.push_back(found);
        all_.truth.push_back(truth);
        if (!is_far(x, y)) return;
        far_.found.push_back(found);
        far_.truth.push_back(truth);
    }
    void report(reports::Measurement& result, const std::string& name) const {
        result.field(name, all_.found, all_.truth);
        result.field(name + ", far", far_.found, far_.truth);
    }

private:
    struct Pairs {
        std::vector<double> found, truth;
    };
    Pairs all_, far_;
};

class Pressed {
public:
    explicit Pressed(int nx) : simulation_(pressed(nx)) { run_steps(simulation_, 1); }

    void compare(reports::Measurement& result) const {
        const reference::ElasticSandwich truth = exact();
        const Grid& grid = simulation_.grid();
        Compared u, v, stress;
        for (int i = 0; i < grid.node_columns(); ++i)
            for (int j = 0; j <= grid.rows(); ++j) {
                const double x = std::min(grid.x(i), 120.0 * um);  // but for round-off
                const Vector found = displacement(i, j);
                const Vector wanted = truth.displacement(x, grid.eta(j));
                u.add(x, grid.eta(j), found.x(), wanted.x());
                v.add(x, grid.eta(j), found.y(), wanted.y());
            }
        for (int i = 0; i < grid.cell_columns(); ++i)
            for (int j = 0; j < grid.rows(); ++j) {
                const double x = grid.x(i) + 0.5 * grid.dx();
                const double y = grid.eta(j) + 0.5 * grid.height(j);
                const PlaneStress found = simulation_.state().stress.mean(i, j);
                const auto wanted = truth.stress(x, y);
                stress.add(x, y, found.s11, wanted.xx);
                stress.add(x, y, found.s22, wanted.yy);
                stress.add(x, y, found.s12, wanted.xy);
            }
        u.report(result, "u");
        v.report(result, "v");
        stress.report(result, "stress");
    }

    /// Nodes of the coarsest grid, and means over its cells, so that no value straddles the
    /// interface.
    void sample(reports::Measurement& result) const {
        const Grid& grid = simulation_.grid();
        const int ratio = 2 * grid.cell_columns() / coarsest;
        std::vector<double> v, far_v, far_stress;
        for (int i = 0; i < grid.node_columns(); i += ratio)
            for (int j = 0; j <= grid.rows(); j += ratio) {
                v.push_back(displacement(i, j).y());
                if (is_far(grid.x(i), grid.eta(j))) far_v.push_back(v.back());
            }
        for (int i = 0; i < grid.cell_columns(); i += ratio)
            for (int j = 0; j < grid.rows(); j += ratio) {
                const double half = 0.5 * ratio * grid.dx();
                if (is_far(grid.x(i) + half, grid.eta(j) + half))
                    far_stress.push_back(mean_stress_22(i, j, ratio));
            }
        result.sample("v", {v, {}})
            .sample("v, far", {far_v, {}})
            .sample("sigma_22, far", {far_stress, {}});
    }

private:
    Vector displacement(int i, int j) const {
        return simulation_.state().velocity(i, j) * simulation_.scene().time.step;
    }

    double mean_stress_22(int first, int lowest, int ratio) const {
        double sum = 0.0;
        for (int i = first; i < first + ratio; ++i)
            for (int j = lowest; j < lowest + ratio; ++j)
                sum += simulation_.state().stress.mean(i, j).s22;
        return sum / (ratio * ratio);
    }

    Simulation simulation_;
};

reports::Measurement measure(int nx) {
    reports::Measurement result(1.0 / nx);
    const Pressed run(nx);
    run.compare(result);
    run.sample(result);
    return result;
}

std::vector<reports::Study> studies() {
    const double lambda = reference::corner_exponent(reference::ap(), reference::binder());
    const double pollution = 2.0 * lambda;
    reports::Study study("sandwich-orders");
    study.refines("columns", {coarsest, 128, 256, 512})
        .measure(measure)
        .covers({term::elasticity, term::equilibrium, term::traction, term::elastic_interface,
                 term::incompressibility})
        .gate("u", Norm::Linf, expect(lambda).within(0.04), "h^lambda beside the corner")
        .gate("v", Norm::Linf, expect(lambda).within(0.04), "h^lambda beside the corner")
        .gate("stress", Norm::L2, expect(lambda).within(0.02, 0.06).from(128),
              "h^(lambda - 1) on an area h^2; the error elsewhere fades faster")
        .gate("u, far", Norm::L2, expect(pollution).within(0.02, 0.25).from(128),
              "h^(2 lambda) sent out by the corner; the element's h^2 fades")
        .gate("v, far", Norm::L2, expect(2.0).within(0.1),
              "the element's h^2 is larger than the pollution on these grids")
        .gate("stress, far", Norm::L2, expect(pollution).within(0.02, 0.4).from(128),
              "between 2 and 2 lambda: both are there")
        .difference_gate("v", Norm::L2, expect(2.0).within(0.1),
                         "points that stay where they are leave the corner behind")
        .difference_gate("v, far", Norm::L2, expect(2.0).within(0.1), "as its error")
        .difference_gate("sigma_22, far", Norm::L2, expect(pollution).within(0.02, 0.5),
                         "between 2 and 2 lambda, as its error");
    return {study};
}

const Registered here{{.name = "sandwich-orders",
                       .figure = "-",
                       .shows = "orders near and far from the singular corner of a cold sandwich",
                       .physics = {physics::sandwich},
                       .cost = {.verify = 8.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
