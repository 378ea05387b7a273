/// # Carried discs: does a disc or a strip that the solid has moved lie where it is now?
///
/// With `morphology.indicator = "reference_map"` a cell asks where its material came from, and takes
/// what lies there. Two motions have exact answers. A solid that has moved as a whole holds discs
/// that lie elsewhere by as much: cell by cell the fractions are those of the moved discs, however
/// far they came, from beyond the sides and from below the window; and so for a strip. And a solid that has flowed
/// without a change of volume, in waves along x and y, holds discs of another shape but of their old
/// area; the cells' straight sides give that up to order two.

#include <cmath>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/comparison.hpp"
#include "solver/materials/material_map.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr double strip = 63.1 * um;
constexpr double pi = std::numbers::pi;

/// On no grid line; one lies across a side. Both are whole in the window and its images, also when the
/// waves have moved them.
const Discs discs{
    .discs = {{91.3 * um, -90.1 * um, 50.2 * um}, {-70.7 * um, -170.9 * um, 31.4 * um}},
    .period = 1.05 * width};

MaterialMap map_of(const Shape& shape, const Grid& grid,
                   Indicator indicator = Indicator::reference_map) {
    return {{.shape = shape,
             .materials = {ammonium_perchlorate(), htpb_binder()},
             .indicator = indicator},
            grid};
}

Grid square(int cells) {
    return Grid({.width = width, .depth = width, .nx = cells, .ny = cells, .clustering = 1.0});
}

/// Where material came from, less where it is [m].
template <class Shift>
NodeVectors shifts(const Grid& grid, const Shift& shift) {
    NodeVectors all(grid.node_columns(), grid.rows() + 1);
    for (int i = 0; i < all.columns(); ++i)
        for (int j = 0; j < all.rows(); ++j) all(i, j) = shift(Vector(grid.x(i), grid.eta(j)));
    return all;
}

/// Largest error of a cell's fraction where the whole solid came from `shift` away.
double moved_as_a_whole(int cells, const Vector& shift) {
    const Grid grid = square(cells);
    Discs moved = discs;
    for (Disc& disc : moved.discs) {
        disc.x -= shift.x();
        disc.y -= shift.y();
    }
    MaterialMap truth = map_of(moved, grid, Indicator::laboratory);
    MaterialMap carried = map_of(discs, grid);
    const SurfaceField level(size_t(grid.node_columns()), 0.0);
    carried.follow(level, shifts(grid, [&](const Vector&) { return shift; }));
    double largest = 0.0;
    for (size_t k = 0; k < truth.fraction().values().size(); ++k)
        largest = std::max(largest,
                           std::abs(carried.fraction().values()[k] - truth.fraction().values()[k]));
    return largest;
}

/// How much of [from, to] a strip about `centre` covers, its images a width apart.
double covered(double from, double to, double centre) {
    double length = 0.0;
    for (const int image : {-2, -1, 0, 1, 2}) {
        const double middle = centre + image * width;
        length += std::max(
            0.0, std::min(to, middle + 0.5 * strip) - std::max(from, middle - 0.5 * strip));
    }
    return length / (to - from);
}

/// The same for the strip, which stands about x = 0 at first.
double strip_moved_as_a_whole(int cells, const Vector& shift) {
    const Grid grid = square(cells);
    MaterialMap carried = map_of(Sandwich{strip}, grid);
    const SurfaceField level(size_t(grid.node_columns()), 0.0);
    carried.follow(level, shifts(grid, [&](const Vector&) { return shift; }));
    double largest = 0.0;
    for (int i = 0; i < cells; ++i)
        largest =
            std::max(largest, std::abs(carried.fraction()(i, 0) - 1.0 +
                                       covered(grid.x(i), grid.x(i) + grid.dx(i), -shift.x())));
    return largest;
}

/// A shear along x after one along y: each keeps areas, so both do.
Vector wave(const Vector& at) {
    constexpr double amplitude = 12.0 * um;
    constexpr double k = 2.0 * pi / width;
    const double x = at.x() + amplitude * std::sin(k * at.y());
    return {x - at.x(), amplitude * std::sin(k * x)};
}

Comparison area_of_disc(int cells) {
    const Grid grid = square(cells);
    MaterialMap carried = map_of(discs, grid);
    const SurfaceField level(size_t(grid.node_columns()), 0.0);
    carried.follow(level, shifts(grid, wave));
    double found = 0.0;
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j)
            found += carried.fraction()(i, j) * grid.dx(i) * grid.height(j);
    double exact = 0.0;
    for (const Disc& disc : discs.discs) exact += pi * disc.radius * disc.radius;
    Comparison area;
    area.add(found, exact);
    return area;
}

constexpr auto area = "area of the discs";
constexpr auto right = "fraction, came from the right and above";
constexpr auto left = "fraction, came from the left and below";
constexpr auto strip_right = "strip: fraction, came from the right";
constexpr auto strip_left = "strip: fraction, came from the left";
const Vector from_right(107.3 * um, 61.9 * um);
const Vector from_left(-107.3 * um, -61.9 * um);

std::vector<reports::Study> studies() {
    reports::Study study("carried-discs");
    study.refines("cells", {32, 64, 128, 256})
        .covers({term::moving_morphology})
        .measure([](int cells) {
            reports::Measurement result(1.0 / cells);
            area_of_disc(cells).report(area, result);
            return result.value(right, moved_as_a_whole(cells, from_right))
                .value(left, moved_as_a_whole(cells, from_left))
                .value(strip_right, strip_moved_as_a_whole(cells, from_right))
                .value(strip_left, strip_moved_as_a_whole(cells, from_left));
        })
        .gate(area, Norm::L2, expect(2.0).within(0.2).from(64),
              "cells whose sides are straight where the solid's are not")
        .bound(right, 256, at_most(1e-9), "the same discs, the same cells: round-off")
        .bound(left, 256, at_most(1e-9), "the same")
        .bound(strip_right, 256, at_most(1e-9), "the same strip: round-off")
        .bound(strip_left, 256, at_most(1e-9), "the same");
    return {study};
}

const Registered here{
    {.name = "carried-discs",
     .figure = "-",
     .shows = "discs and strips that the solid carries lie where it has taken them",
     .physics = {physics::pack},
     .cost = {.verify = 1.0},
     .studies = studies}};

}  // namespace

}  // namespace crawford
