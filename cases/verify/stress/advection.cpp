/// # Advection: at which order does the solver carry stress?
///
/// A motion without spin is prescribed and `StressStep::predict` takes one step. Nothing but
/// advection then changes the stress, and (sigma* - sigma)/dt is the rate that the discretisation
/// gives, free of any error in time: held against -(v - v_grid).grad(sigma) of a profile with a
/// gradient in closed form (reference/carried_profile.hpp) it shows the truncation error itself.
/// One profile is carried on for a third of its period as well.
///
/// What to expect. The scheme is third-order WENO for a derivative (not for a flux): it weighs two
/// second-order stencils by their second differences. Its critical points are therefore not the
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
/// A jump is carried as well: it smears, at order 3/4 in L1 as third-order upwinding does, but must
/// not overshoot, for which all the weighing is there. (Curved surfaces:
/// cases/verify/stress/advection_curved.cpp.)

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/ssp_step.hpp"
#include "cases/verify/stress/carried_stress.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::ColumnShape;
using reference::ProfileShape;
using reports::between;
using reports::expect;
using reports::Norm;
using namespace carried;

constexpr double width = 240.0 * um;
constexpr double depth = 480.0 * um;
constexpr double speed = 5e-3 * m / s;
constexpr double wave_number = 2.0 * std::numbers::pi / width;
constexpr double strong = 1e4 * MPa;
constexpr double weak = 1e-3 * MPa;

constexpr double way = width / 3.0;

constexpr auto overshoot = "overshoot of a jump [%]";
constexpr auto logarithm = "WENO3: h^3 log(1/h) beside inflections; the logarithm costs 0.3 to 0.5";

Domain row(int cells) {
    return {.width = width, .depth = width / cells, .nx = cells, .ny = 1, .clustering = 0.0};
}

std::function<Domain(int)> column(double clustering) {
    return [=](int cells) -> Domain {
        return {.width = width, .depth = depth, .nx = 1, .ny = cells, .clustering = clustering};
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

reports::Study study_of(const std::string& name, const CarriedSetup& setup) {
    reports::Study study("advection, " + name);
    study.refines("cells", {32, 64, 128, 256})
        .measure([setup](int cells) { return measure_rates(setup, cells); })
        .covers({term::stress_advection});
    return study;
}

/// Inflections decide: three less a logarithm in L1, two in Linf.
reports::Study inflected(const std::string& name, const CarriedSetup& setup) {
    reports::Study study = study_of(name, setup);
    for (const auto* quantity : {points, pressure})
        study.gate(quantity, Norm::L1, expect(3.0).within(0.5, 0.1).from(64), logarithm)
            .gate(quantity, Norm::Linf, expect(2.0).within(0.15).from(64),
                  "at an inflection one stencil has all the weight");
    return study;
}

reports::Study without_inflection(const std::string& name, const CarriedSetup& setup) {
    reports::Study study = study_of(name, setup);
    for (const auto* quantity : {points, pressure})
        study.gate(quantity, Norm::L1, expect(3.0).within(0.1), "WENO3 without a critical point")
            .gate(quantity, Norm::Linf, expect(2.0).within(0.1), "one-sided in the last row");
    study.bound(first_row, 256, between(0.0, 0.0), "enters with zero gradient");
    return study;
}

reports::Study weakly(const std::string& name, const CarriedSetup& setup) {
    reports::Study study = study_of(name, setup);
    for (const auto* quantity : {points, pressure})
        study.gate(quantity, Norm::Linf, expect(3.0).within(0.05),
                   "below 1 kPa the weights are linear: third-order upwind at every cell");
    return study;
}

/// Carries a stress along a row for a third of the period, by Runge-Kutta steps.
StressField carry(const PrescribedMotion& body, StressField stress) {
    const auto blend = [](double a, const StressField& x, double b, const StressField& y) {
        StressField sum = x;
        for (int i = 0; i < x.pressure.columns(); ++i) {
            for (size_t k = 0; k < x.deviator.size(); ++k)
                sum.deviator[k](i, 0) = a * x.deviator[k](i, 0) + b * y.deviator[k](i, 0);
            sum.pressure(i, 0) = a * x.pressure(i, 0) + b * y.pressure(i, 0);
        }
        return sum;
    };
    const int steps = 2 * body.grid().cell_columns();
    const double dt = way / speed / steps;
    const auto euler = [&](StressField start) {
        body.stress_step().predict(start, body.motion(), {}, 0.0, dt);
        return start;
    };
    for (int n = 0; n < steps; ++n) stress = ssp_step(stress, euler, blend);
    return stress;
}

reports::Measurement carry_wave(int cells) {
    const PrescribedMotion body(row(cells), along_a_row(speed));
    const CarriedStress start(wave(strong));
    const StressField stress = carry(body, start.on(body));
    Comparison deviator;
    for (const CellPoint& at : body.stress_points())
        deviator.add(stress.deviator[size_t(at.point)](at.i, at.j),
                     start.deviator(at.x - Vector(way, 0.0)), at.weight);
    reports::Measurement result(1.0 / cells);
    deviator.report(points, result);
    return result;
}

/// 100 MPa in half the row and none in the other.
reports::Measurement carry_jumps(int cells) {
    const PrescribedMotion body(row(cells), along_a_row(speed));
    const double height = 100.0 * MPa;
    const auto start = [&](double x) { return std::sin(wave_number * x) > 0.0 ? height : 0.0; };
    StressField stress = body.no_stress();
    const auto centres = body.centres();
    for (const CellPoint& at : centres) stress.pressure(at.i, at.j) = start(at.x.x());
    stress = carry(body, stress);
    Comparison pressures;
    double beyond = 0.0;
    for (const CellPoint& at : centres) {
        const double p = stress.pressure(at.i, at.j);
        pressures.add(p, start(at.x.x() - way));
        beyond = std::max({beyond, p - height, -p});
    }
    reports::Measurement result(1.0 / cells);
    pressures.report(pressure, result);
    return result.value(overshoot, 100.0 * beyond / height);
}

std::vector<reports::Study> studies() {
    reports::Study evolved("advection, carried for a third of a period");
    evolved.refines("cells", {32, 64, 128, 256})
        .measure(carry_wave)
        .covers({term::stress_advection})
        .gate(points, Norm::L1, expect(3.0).within(0.5, 0.1).from(64), logarithm);
    reports::Study jump("advection, jumps carried for a third of a period");
    jump.refines("cells", {32, 64, 128, 256})
        .measure(carry_jumps)
        .covers({term::stress_advection})
        .gate(pressure, Norm::L1, expect(0.75).within(0.1), "smears as t^(1/4) h^(3/4)")
        .bound(overshoot, 256, between(0.0, 0.1),
               "the weights close the stencil that holds the jump: nearly none");
    return {
        inflected("along a row, bbar", {row, along_a_row(speed), wave(strong)}),
        inflected("back along a row, q1", {row, along_a_row(-speed), wave(strong), Element::q1}),
        weakly("a weak stress along a row, bbar", {row, along_a_row(speed), wave(weak)}),
        without_inflection("up a column, convex", {column(0.0), along_a_column(speed), convex()}),
        inflected("up a clustered column",
                  {column(2.0), along_a_column(speed), bump(-0.25 * depth, depth / 8.0)}),
        inflected("down a column, q1", {column(0.0), along_a_column(-speed),
                                        bump(-0.5 * depth, depth / 8.0), Element::q1}),
        evolved,
        jump};
}

const Registered here{{.name = "advection",
                       .figure = "-",
                       .shows = "stress carried by a prescribed motion",
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
