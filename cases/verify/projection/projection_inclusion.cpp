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

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/verify/projection/elastic_inclusion.hpp"

namespace crawford {

namespace {

using reports::expect;
using reports::Norm;

reports::Measurement measure(const DiscAndMatrix& pair, int cells) {
    reports::Measurement result(1.0 / cells);
    measure_inclusion(inclusion_scene(pair, cells), faded_inclusion(pair), "", result);
    return result;
}

reports::Study study(const std::string& name, const DiscAndMatrix& pair, std::vector<int> grids) {
    reports::Study study("projection-inclusion, " + name);
    study.refines("cells", std::move(grids))
        .measure([pair](int cells) { return measure(pair, cells); })
        .covers({term::elasticity, term::equilibrium, term::elastic_interface});
    return study;
}

std::vector<reports::Study> studies() {
    using reference::ap;
    using reference::binder;
    const auto smooth = expect(2.0).within(0.15);
    auto none = study("no interface", {ap(), ap()}, {32, 64, 128});
    none.gate("displacement", Norm::L2, smooth, "bilinear elements on a smooth field")
        .gate("displacement", Norm::Linf, smooth, "the same at the worst node")
        .gate("stress", Norm::L2, smooth, "centres of cells are where the gradient is of order 2");
    auto soft = study("binder in AP", {binder(), ap()}, {32, 64, 128, 256});
    soft.gate("displacement", Norm::L2, expect(1.0).within(0.1),
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
