/// # A speed that jumps: does the faster side lead, wherever the interface lies?
///
/// phi_t = -r(x) sqrt(1 + phi_x^2) with a rate that jumps has one stable solution, that of the
/// fastest path (reference/jumping_front.hpp): level over the faster material, and beside it a plane
/// that the interface drags through the slower one. A mean of the two rates at the interface, the
/// nearest thing to do, drags too slowly for ever: the plane is then wrong by a fixed slope, on
/// every grid.
///
/// The rates are given, so the front is tried by itself: interfaces on nodes, between nodes, hard by
/// a node, a strip of less than a cell, and the faster material inside or outside. The sides of the
/// strip stand at no simple part of a cell on any grid.
///
/// - At the interface, and where head waves meet, the front has kinks: order one in Linf, as far as
///   a kink reaches.
/// - Where a slab leans, the front around its lower edge leads under it: a cliff of some 20 um along
///   the slab's face, placed to one column. What is a column away from the cliff is gated.
/// - Away from kinks every piece is a plane, which any scheme of second order has exactly: what is
///   left there is what the kinks sent out. The start sends it: over the slower material a plane
///   grows out of a point.

#include <algorithm>
#include <cmath>
#include <functional>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/burning/burn_surface.hpp"
#include "reference/jumping_front.hpp"
#include "reference/refracted_front.hpp"
#include "solver/burning/surface_motion.hpp"
#include "solver/materials/material_map.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr double fast = 5.0e-3 * m / s;
constexpr double slow = 2.5e-3 * m / s;

constexpr auto height = "phi";
constexpr auto mean_error = "mean error of phi [cells]";
constexpr auto away = "phi away from kinks [um]";

reference::JumpingRate strip_of(double strip, double strip_rate, double outer_rate) {
    return {.width = width,
            .left = -0.5 * strip,
            .right = 0.5 * strip,
            .strip_rate = strip_rate,
            .outer_rate = outer_rate};
}

/// What the surface is made of where it now stands.
using PiecesOf = std::function<SurfacePieces(const SurfaceField&)>;

/// Burns a level surface for `duration`; the first material is what surrounds a strip.
SurfaceField burn(const Grid& grid, const PiecesOf& pieces, double outer_rate, double strip_rate,
                  double duration) {
    const RateOfMaterial rate = [&](double fraction, const SurfacePlace&) {
        return fraction == 1.0 ? outer_rate : strip_rate;
    };
    const int steps = int(std::ceil(2.5 * duration * fast / grid.dx()));
    return burn_surface(SurfaceField(size_t(grid.node_columns()), 0.0), duration, steps,
                        [&](const SurfaceField& phi, double dt) {
                            return surface_rate(grid, phi, pieces(phi), rate, {}, dt);
                        });
}

double distance_to(const std::vector<double>& kinks, double x) {
    double nearest = width;
    for (const double kink : kinks)
        nearest = std::min(nearest, std::abs(std::remainder(x - kink, width)));
    return nearest;
}

template <class Exact>
reports::Measurement compare(const Grid& grid, const SurfaceField& found, const Exact& exact,
                             double duration) {
    const std::vector<double> kinks = exact.kinks(duration);
    SurfaceField truth;
    double worst = 0.0;
    for (int i = 0; i < grid.node_columns(); ++i) {
        truth.push_back(exact.height(grid.x(i), duration));
        const double error = std::abs(found[size_t(i)] - truth.back());
        if (distance_to(kinks, grid.x(i)) > width / 16.0) worst = std::max(worst, error);
    }
    return reports::Measurement(1.0 / grid.cell_columns())
        .field(height, found, truth)
        .value(away, worst / um)
        .value(mean_error, reports::distance(Norm::L1, found, truth) / grid.dx());
}

reports::Measurement front(const reference::JumpingRate& given, int cells) {
    const reference::JumpingFront exact(given);
    const double duration = 20.0 * um / slow;
    const Grid grid({.width = width, .depth = width, .nx = cells, .ny = 2});
    const Morphology sandwich{.shape = Sandwich{given.right - given.left},
                              .materials = {ammonium_perchlorate(), htpb_binder()}};
    const MaterialMap materials(sandwich, grid);
    const auto pieces = [&](const SurfaceField&) { return materials.surface_pieces(); };
    return compare(grid, burn(grid, pieces, given.outer_rate, given.strip_rate, duration), exact,
                   duration);
}

/// What a slab between leaning faces covers of the surface, by its images a period apart.
SurfacePieces leaning_pieces(const Grid& grid, const SurfaceField& surface,
                             const reference::InclinedSlab& slab) {
    SurfacePieces pieces;
    const double half = 0.5 * (slab.right - slab.left);
    for (int i = 0; i < grid.cell_columns(); ++i) {
        std::vector<Covered> covered;
        for (int image = -2; image <= 2; ++image) {
            const double middle = 0.5 * (slab.left + slab.right) + image * width;
            const auto upright = [&](double x, int node) -> Vector {
                const double y = surface[size_t(node)];
                return {x - slab.lean * y - middle, y};
            };
            if (const auto part = covered_by_strip(
                    {upright(grid.x(i), i), upright(grid.x(i) + grid.dx(i), grid.right_node(i))},
                    half))
                covered.push_back(*part);
        }
        pieces.push_back(pieces_of(std::move(covered), 0.0, {1.0, 1.0}));
    }
    return pieces;
}

/// Crosses a slower slab from above and leaves it below.
reports::Measurement refraction(double lean, int cells) {
    const reference::InclinedSlab slab{.left = -30.0 * um,
                                       .right = 34.1 * um,
                                       .lean = lean,
                                       .slab_rate = slow,
                                       .outer_rate = fast,
                                       .width = width};
    const reference::RefractedFront exact(slab);
    const double duration = 40.0 * um / fast;
    const Grid grid({.width = width, .depth = width, .nx = cells, .ny = 2});
    const auto pieces = [&](const SurfaceField& phi) { return leaning_pieces(grid, phi, slab); };
    return compare(grid, burn(grid, pieces, fast, slow, duration), exact, duration);
}

reports::Study jump(const std::string& name, const reference::JumpingRate& given) {
    reports::Study study("front-jump, " + name);
    study.refines("columns", {32, 64, 128, 256})
        .measure([=](int cells) { return front(given, cells); })
        .covers({term::surface_motion, term::surface_jump})
        .gate(
            height, Norm::L1, expect(2.0).or_better(0.4).scattering(1.3).from(64),
            "planes are exact: order h at the few nodes beside kinks alone, which wander in cells")
        .bound(away, 256, at_most(1e-6),
               "round-off; a plane of wrong slope, as a mean of the rates drags it, is cells off");
    return study;
}

reports::Study leaning(const std::string& name, double lean) {
    reports::Study study("front-jump, " + name);
    study.refines("columns", {32, 64, 128, 256})
        .measure([=](int cells) { return refraction(lean, cells); })
        .covers({term::surface_motion, term::surface_jump})
        .bound(away, 256, at_most(1e-6), "round-off")
        .bound(mean_error, 256, at_most(0.2),
               "the cliff stands a part of a column off, 18 um high: 0.08 seen");
    return study;
}

std::vector<reports::Study> studies() {
    return {jump("slow strip, interfaces on nodes", strip_of(60.0 * um, slow, fast)),
            jump("slow strip, interfaces between nodes", strip_of(64.1 * um, slow, fast)),
            jump("slow strip, interfaces hard by nodes", strip_of(60.001 * um, slow, fast)),
            jump("fast strip, interfaces between nodes", strip_of(64.1 * um, fast, slow)),
            jump("fast strip of less than a cell", strip_of(0.7 * um, fast, slow)),
            leaning("slow slab that leans to the right", 0.4),
            leaning("slow slab that leans to the left", -0.4)};
}

const Registered here{{.name = "front-jump",
                       .figure = "-",
                       .shows = "the front where the burn rate jumps",
                       .cost = {.verify = 2.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
