/// # Surface: does the front burn along its normal, before a kink and after it?
///
/// phi_t = -r_b sqrt(1 + phi_x^2) at a constant rate is Huygens' construction, with exact solutions
/// (reference/regressing_front.hpp): by characteristics while the front is smooth, by the Hopf-Lax
/// formula for ever. `surface_rate` is held against them by itself, without heat, first one rate of
/// it and then evolved by Runge-Kutta steps of third order, dt ~ h.
///
/// - Smooth. The slopes are third-order WENO, with the inflections of the slope for critical points
///   (cases/verify/stress/advection.cpp explains): where the front is steep, two in Linf and three
///   less a logarithm in L1; where slopes change by less than 1e-3 from cell to cell, three in
///   Linf. In between, as on the grids of the evolved waves, the error passes from the first line
///   to the lower second one and falls faster than either: what is asked there is "2.6 or better".
/// - A kink lies anywhere between two nodes; one or two nodes beside it are wrong by order h. The
///   rest never hears of them, because characteristics run into a kink: two in L1. At those nodes
///   the error cannot exceed the jump of slope times a cell: bounded in cells.
/// - A kink that opens. Everything in an arc comes out of the first kink, where one cell is all the
///   resolution there is: the error of order h of the first moments spreads over the whole arc.
///   One, in L1 as in Linf, whatever the scheme.
/// - A front that the material carries too (surface_motion = "burning_with_material"): a uniform
///   velocity shifts the exact solution.
/// - The mean burn rate is an average over the true length of the front: against quadrature.

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/burning/burn_surface.hpp"
#include "reference/regressing_front.hpp"
#include "solver/burning/burn_rate.hpp"
#include "solver/burning/surface_motion.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr double burn_rate = 4.5e-3 * m / s;
constexpr double wave_number = 2.0 * std::numbers::pi / width;
// Of the first crest: a third of the period lies a third of a cell beside a node on every grid.
constexpr double offset = width / 3.0;

constexpr auto rate = "phi_t";
constexpr auto carried_rate = "phi_t with the material";
constexpr auto mean_rate = "mean burn rate";
constexpr auto beside_crest = "largest error beside the crests [cells]";

Grid grid_of(int cells, bool half = false) {
    return Grid({.width = width, .depth = width, .nx = cells, .ny = 2, .half = half});
}

template <class Function>
auto at_nodes(const Grid& grid, const Function& f) {
    std::vector<decltype(f(0.0))> result;
    for (int i = 0; i < grid.node_columns(); ++i) result.push_back(f(grid.x(i)));
    return result;
}

/// A cosine with its crest at `crest`, its rate where r_b and the material's velocity vary along
/// it, and its mean burn rate.
reports::Measurement wave_rate(double amplitude, double crest, bool half, int cells) {
    const auto phi = [&](double x) { return amplitude * std::cos(wave_number * (x - crest)); };
    const auto slope = [&](double x) {
        return -amplitude * wave_number * std::sin(wave_number * (x - crest));
    };
    const auto r = [](double x) {
        return burn_rate * (1.0 + 0.5 * std::cos(2.0 * wave_number * x));
    };
    const auto velocity = [](double x) -> Vector {
        return 0.3 * burn_rate * Vector(std::sin(wave_number * x), std::cos(wave_number * x));
    };
    const auto burning = [&](double x) { return -r(x) * std::hypot(1.0, slope(x)); };
    const auto carried = [&](double x) {
        return burning(x) + velocity(x).y() - velocity(x).x() * slope(x);
    };
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
    const auto over_period = [&](const auto& f) {
        return Quadrature::integrate(f, -0.5 * width, 0.5 * width);
    };
    const double length = over_period([&](double x) { return std::hypot(1.0, slope(x)); });

    const Grid grid = grid_of(cells, half);
    const SurfaceField surface = at_nodes(grid, phi);
    const SurfaceField rates = at_nodes(grid, r);
    return reports::Measurement(1.0 / cells)
        .field(rate, surface_rate(grid, surface, rates, {}), at_nodes(grid, burning))
        .field(carried_rate, surface_rate(grid, surface, rates, at_nodes(grid, velocity)),
               at_nodes(grid, carried))
        .value(mean_rate, mean_burn_rate(grid, surface, rates), -over_period(burning) / length);
}

/// Burns `surface` for `duration` at a uniform rate, carried by a uniform velocity.
SurfaceField burn(const Grid& grid, SurfaceField surface, double duration, const Vector& velocity) {
    const SurfaceField rates(surface.size(), burn_rate);
    const std::vector<Vector> material(velocity.isZero() ? 0 : surface.size(), velocity);
    const int steps = int(std::ceil(2.5 * duration * burn_rate / grid.dx()));
    return burn_surface(std::move(surface), duration, steps, [&](const SurfaceField& phi, double) {
        return surface_rate(grid, phi, rates, material);
    });
}

/// A wave at `part` of its time to the kink; beyond 1 it is after it.
reports::Measurement burn_wave(double part, const Vector& velocity, int cells) {
    const reference::RegressingWave exact(20.0 * um, width, burn_rate);
    const double end = part * exact.kink_time();
    const Grid grid = grid_of(cells);
    const auto phi = [&](double t) {
        return at_nodes(grid, [&](double x) {
            return exact.envelope(x - offset - velocity.x() * t, t) + velocity.y() * t;
        });
    };
    const SurfaceField found = burn(grid, phi(0.0), end, velocity);
    const SurfaceField truth = phi(end);
    return reports::Measurement(1.0 / cells)
        .field("phi", found, truth)
        .value(beside_crest, reports::distance(Norm::Linf, found, truth) / grid.dx());
}

/// A zigzag of unequal slopes with a valley at x = 0: its crests wander through the grid.
reports::Measurement burn_zigzag(int cells) {
    const reference::RegressingZigzag exact(0.9, 0.5, width, burn_rate);
    const double reach = 0.25 * width;
    const double end = reach / burn_rate;
    const Grid grid = grid_of(cells);
    const auto phi = [&](double t) {
        return at_nodes(grid, [&](double x) { return exact.height(x, t); });
    };
    const SurfaceField found = burn(grid, phi(0.0), end, Vector::Zero());
    const SurfaceField truth = phi(end);
    double worst = 0.0;
    for (int i = 0; i < grid.node_columns(); ++i)
        if (std::abs(grid.x(i)) > 1.2 * reach)
            worst = std::max(worst, std::abs(found[size_t(i)] - truth[size_t(i)]));
    return reports::Measurement(1.0 / cells)
        .field("phi", found, truth)
        .value(beside_crest, worst / grid.dx());
}

reports::Study study_of(const std::string& name, const reports::MeasureGrid& measure) {
    reports::Study study("surface, " + name);
    study.refines("columns", {32, 64, 128, 256}).measure(measure).covers({term::surface_motion});
    return study;
}

reports::Study steep(const std::string& name, double crest, bool half) {
    reports::Study study =
        study_of(name, [=](int cells) { return wave_rate(120.0 * um, crest, half, cells); });
    study.refines("columns", {16, 32, 64, 128});
    for (const auto* quantity : {rate, carried_rate})
        study
            .gate(quantity, Norm::L1, expect(3.0).within(0.5, 0.1).from(32),
                  "WENO3: h^3 log(1/h) beside inflections; the logarithm costs 0.3 to 0.5")
            .gate(quantity, Norm::Linf, expect(2.0).within(0.15).from(32),
                  "at an inflection one stencil has all the weight");
    study.gate(mean_rate, Norm::magnitude, expect(2.0).within(0.05), "straight pieces of surface");
    return study;
}

reports::Study nearly_level() {
    reports::Study study = study_of("rate of a nearly level wave", [](int cells) {
        return wave_rate(0.05 * um, offset, false, cells);
    });
    study.gate(carried_rate, Norm::Linf, expect(3.0).within(0.1),
               "changes of slope below 1e-3: third-order upwind at every node");
    return study;
}

reports::Study smooth(const std::string& name, const Vector& velocity) {
    reports::Study study =
        study_of(name, [=](int cells) { return burn_wave(0.5, velocity, cells); });
    study.gate("phi", Norm::L1, expect(3.0).or_better(0.4).scattering(0.5),
               "WENO3, passing from its steep regime to its linear one");
    return study;
}

reports::Study kinked(const std::string& name, const Vector& velocity) {
    reports::Study study =
        study_of(name, [=](int cells) { return burn_wave(1.5, velocity, cells); });
    study.covers({term::surface_motion, term::surface_kink})
        .gate(
            "phi", Norm::L1, expect(2.0).or_better(0.1).scattering(0.9),
            "order h at the nodes beside the kink alone; scatters with the kink's place in a cell")
        .bound(beside_crest, 256, between(0.0, 0.2),
               "the jump of slope, 1.5, times what is left of a cell: 0.08 seen");
    ;
    return study;
}

reports::Study zigzag() {
    reports::Study study = study_of("kinks that open and kinks that wander", burn_zigzag);
    study.covers({term::surface_motion, term::surface_kink});
    for (const Norm norm : {Norm::L1, Norm::Linf})
        study.gate("phi", norm, expect(1.0).within(0.15),
                   "the arcs keep the error of order h of their first cell");
    study.bound(beside_crest, 256, between(0.0, 0.2),
                "the jump of slope, 1.4, times what is left of a cell: 0.06 at the worst place");
    return study;
}

std::vector<reports::Study> studies() {
    const Vector drift = burn_rate * Vector(0.2, 0.1);
    return {steep("rate of a steep wave", offset, false),
            steep("rate of half a steep wave", 0.0, true),
            nearly_level(),
            smooth("wave before its kink", Vector::Zero()),
            smooth("carried wave before its kink", drift),
            kinked("wave after its kink", Vector::Zero()),
            kinked("carried wave after its kink", drift),
            zigzag()};
}

const Registered here{{.name = "surface",
                       .figure = "-",
                       .shows = "the burning front before and after a kink",
                       .cost = {.verify = 2.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
