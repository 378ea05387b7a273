/// # Advection: at which order does the solver carry stress?
///
/// A motion without spin is prescribed and `StressStep::predict` takes one step. Nothing but
/// advection then changes the stress, and (sigma* - sigma)/dt is the rate that the discretisation
/// gives, free of any error in time: held against -(v - v_grid).grad(sigma) of a profile with a
/// gradient in closed form (reference/carried_profile.hpp) it shows the truncation error itself.
/// One profile is carried on for a third of its period as well.
///
/// What to expect. The scheme is third-order WENO for a derivative (not for a flux): it weighs two
/// second-order stencils by their *second* differences. Its critical points are therefore not the
/// extrema of a profile but its inflections. There the weights miss 1/3 by order one and the error
/// is h^2 (Linf: two); at a distance d the miss fades as h/d, so the sum over all cells is
/// h^3 log(1/h): three in L1 less a logarithm, which over these grids costs 0.3 to 0.5. Where
/// second differences stay below the 1 kPa that the solver takes for smooth, the weights are 1/3
/// everywhere: three in Linf too. The profiles are therefore either far stronger than that (10 GPa:
/// every difference counts) or far weaker (1 kPa: none does); between the two the error only passes
/// from one line to the other, and no order could be read.
///
/// Neither clustering nor the Gauss points cost an order: the points of one kind form a lattice of
/// their own, and the solver divides by exactly that lattice's metric. The last row has no cell
/// ahead of it and row 1 none two behind: second order in one row each, which is two in Linf and
/// three in L1. In row 0 stress enters with zero gradient: it must not change at all.
///
/// A curved surface does cost. All points of a cell take the slope of the straight piece of surface
/// over it, where their lattice has phi_x at their own x: an error phi_xx (a - 1/2) dx u dsigma/dy,
/// first order, opposite at the left and the right points. In the mean over a cell, and at the
/// centre, where q1 and the pressure live, it cancels and leaves two.

#include <cmath>
#include <numbers>

#include "cases/catalogue/carried_stress.hpp"
#include "cases/catalogue/registry.hpp"
#include "cases/catalogue/ssp_step.hpp"
#include "cases/catalogue/terms.hpp"
#include "cases/catalogue/units.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::ColumnShape;
using reference::ProfileShape;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr double depth = 480.0 * um;
constexpr double speed = 5e-3 * m / s;
constexpr double wave_number = 2.0 * std::numbers::pi / width;
constexpr double strong = 1e4 * MPa;
constexpr double weak = 1e-3 * MPa;

constexpr auto points = "deviator at its points";
constexpr auto mean = "deviator, mean of a cell";
constexpr auto pressure = "pressure";
constexpr auto first_row = "fastest change in the first row [Pa/s]";
constexpr auto logarithm = "WENO3: h^3 log(1/h) beside inflections; the logarithm costs 0.3 to 0.5";

struct Setup {
    std::string name;
    std::function<Domain(int cells)> domain;
    Motion motion;
    ProfileShape profile;
    Element element = Element::bbar;
};

Domain row(int cells) {
    return {.width = width, .depth = width / cells, .nx = cells, .ny = 1, .clustering = 0.0};
}

std::function<Domain(int)> column(double clustering) {
    return [=](int cells) -> Domain {
        return {.width = width, .depth = depth, .nx = 1, .ny = cells, .clustering = clustering};
    };
}

std::function<Domain(int)> window(bool half) {
    return [=](int cells) -> Domain {
        return {.width = width,
                .depth = depth,
                .nx = cells,
                .ny = cells,
                .clustering = 2.0,
                .half = half};
    };
}

Motion along_a_row(double u) {
    return {.velocity = [=](const Vector&) { return Vector(u, 0.0); }};
}

/// Material and surface together carry the profile across the grid, upward where v > 0.
Motion along_a_column(double v) {
    return {.surface_rate = [=](double) { return -0.7 * v; },
            .velocity = [=](const Vector&) { return Vector(0.0, 0.3 * v); }};
}

/// A flow without spin under a curved surface that moves at another rate at every place.
Motion under_a_curved_surface() {
    const auto flow = [](const Vector& x) -> Vector {
        return 0.5 * speed * std::exp(wave_number * x.y()) *
               Vector(std::sin(wave_number * x.x()), -std::cos(wave_number * x.x()));
    };
    return {
        .surface = [](double x) { return 10.0 * um * std::cos(wave_number * x); },
        .surface_rate = [](double x) { return -speed * (1.0 + 0.3 * std::cos(wave_number * x)); },
        .velocity = flow};
}

ProfileShape wave(double amplitude) {
    return {.amplitude = amplitude, .period = width};
}

/// Nothing is left of it at the bottom.
ProfileShape bump(double middle, double size, double period = 0.0) {
    return {.amplitude = strong,
            .period = period,
            .column = ColumnShape::bump,
            .middle = middle,
            .width = size};
}

ProfileShape convex() {
    return {.amplitude = strong, .column = ColumnShape::exponential, .width = depth / 4.0};
}

reports::Study study_of(const Setup& setup) {
    const auto measure = [setup](int cells) {
        const PrescribedMotion body(setup.domain(cells), setup.motion, setup.element);
        const CarriedStress truth(setup.profile);
        const StressRates rates(body, truth, setup.motion);
        reports::Measurement result(1.0 / cells);
        rates.at_points().report(points, result);
        rates.mean_of_cells().report(mean, result);
        rates.pressure().report(pressure, result);
        return result.value(first_row, rates.fastest_in_first_row());
    };
    reports::Study study("advection, " + setup.name);
    study.grids({32, 64, 128, 256}).measure(measure).covers({term::stress_advection});
    return study;
}

/// Inflections decide: three less a logarithm in L1, two in Linf.
reports::Study inflected(const Setup& setup) {
    reports::Study study = study_of(setup);
    for (const auto* quantity : {points, pressure})
        study.gate(quantity, Norm::L1, expect(3.0).within(0.5, 0.1).from(64), logarithm)
            .gate(quantity, Norm::Linf, expect(2.0).within(0.15).from(64),
                  "at an inflection one stencil has all the weight");
    return study;
}

reports::Study without_inflection(const Setup& setup) {
    reports::Study study = study_of(setup);
    for (const auto* quantity : {points, pressure})
        study.gate(quantity, Norm::L1, expect(3.0).within(0.1), "WENO3 without a critical point")
            .gate(quantity, Norm::Linf, expect(2.0).within(0.1), "one-sided in the last row");
    study.bound(first_row, 256, between(0.0, 0.0), "enters with zero gradient");
    return study;
}

reports::Study weakly(const Setup& setup) {
    reports::Study study = study_of(setup);
    for (const auto* quantity : {points, pressure})
        study.gate(quantity, Norm::Linf, expect(3.0).within(0.05),
                   "below 1 kPa the weights are linear: third-order upwind at every cell");
    return study;
}

reports::Study curved(const Setup& setup) {
    reports::Study study = study_of(setup);
    study.covers({term::stress_advection, term::slope, term::clustering, term::grid_motion});
    for (const auto* quantity : {mean, pressure})
        study
            .gate(quantity, Norm::L1, expect(2.0).or_better(0.1),
                  "slope of the cell, bilinear velocity: 2; inflections, h^3 log(1/h), are larger")
            .gate(quantity, Norm::Linf, expect(2.0).within(0.15).from(64), "both of these");
    if (setup.element == Element::bbar)
        study.gate(points, Norm::Linf, expect(1.0).or_better(0.1),
                   "phi_x at a Gauss point taken at the centre of its cell: dx phi_xx/sqrt(12)");
    return study;
}

/// The wave carried for a third of its period.
reports::Measurement carried(int cells) {
    const Motion motion = along_a_row(speed);
    const PrescribedMotion body(row(cells), motion);
    const double way = width / 3.0;
    const int steps = 2 * cells;
    const double dt = way / speed / steps;
    const auto blend = [](double a, const StressField& x, double b, const StressField& y) {
        StressField sum = x;
        for (int i = 0; i < x.pressure.columns(); ++i) {
            for (size_t k = 0; k < x.deviator.size(); ++k)
                sum.deviator[k](i, 0) = a * x.deviator[k](i, 0) + b * y.deviator[k](i, 0);
            sum.pressure(i, 0) = a * x.pressure(i, 0) + b * y.pressure(i, 0);
        }
        return sum;
    };
    const auto euler = [&](StressField stress) {
        body.stress_step().predict(stress, body.motion(), {}, 0.0, dt);
        return stress;
    };
    const CarriedStress start(wave(strong));
    StressField stress = start.on(body);
    for (int n = 0; n < steps; ++n) stress = ssp_step(stress, euler, blend);

    Comparison deviator;
    for (const CellPoint& at : body.stress_points())
        deviator.add(stress.deviator[size_t(at.point)](at.i, at.j),
                     start.deviator(at.x - Vector(way, 0.0)), at.weight);
    reports::Measurement result(1.0 / cells);
    deviator.report(points, result);
    return result;
}

std::vector<reports::Study> studies() {
    reports::Study evolved("advection, carried for a third of a period");
    evolved.grids({32, 64, 128, 256})
        .measure(carried)
        .covers({term::stress_advection})
        .gate(points, Norm::L1, expect(3.0).within(0.5, 0.1).from(64), logarithm);
    return {
        inflected({"along a row, bbar", row, along_a_row(speed), wave(strong)}),
        inflected({"back along a row, q1", row, along_a_row(-speed), wave(strong), Element::q1}),
        weakly({"a weak stress along a row, bbar", row, along_a_row(speed), wave(weak)}),
        without_inflection({"up a column, convex", column(0.0), along_a_column(speed), convex()}),
        inflected({"up a clustered column", column(2.0), along_a_column(speed),
                   bump(-0.25 * depth, depth / 8.0)}),
        inflected({"down a column, q1", column(0.0), along_a_column(-speed),
                   bump(-0.5 * depth, depth / 8.0), Element::q1}),
        curved({"under a curved surface, bbar", window(false), under_a_curved_surface(),
                bump(-0.125 * depth, depth / 6.0, width)}),
        curved({"under a curved surface, q1", window(false), under_a_curved_surface(),
                bump(-0.125 * depth, depth / 6.0, width), Element::q1}),
        curved({"under half a curved surface, bbar", window(true), under_a_curved_surface(),
                bump(-0.125 * depth, depth / 6.0, width)}),
        evolved};
}

const Registered here{{.name = "advection",
                       .figure = "-",
                       .shows = "stress carried by a prescribed motion",
                       .cost = {.verify = 5.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
