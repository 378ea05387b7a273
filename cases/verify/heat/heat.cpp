/// # Heat: is every term of the heat equation there, and of second order in space?
///
/// The temperature is made up (reference/manufactured_heat.hpp): waves in x, bent in y, different
/// at every point. A source and a surface flux, found from it by automatic differentiation, make it
/// the solution of the heat equation, so whatever the heat step returns beside it is the step's
/// error. Surface and velocity are prescribed; nothing else of the solver runs.
///
/// Each study switches on one term, so that a fault is named. All but one are steady in the frame
/// of the surface: four steps from the exact temperature then show the error in space and none in
/// time. The moving grid is the exception: there the temperature swings, the surface sinks by 4.5
/// um and its wave grows, motion is taken at the middle of the step, and dt falls with h: second
/// order in both. The stress work has a study of its own, and so has time (heat-time).

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/heat/prescribed_heat.hpp"
#include "reference/material.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::HeatedSolid;
using reports::expect;
using reports::Norm;

constexpr int steady_steps = 4;
constexpr double clustered = 2.0;
constexpr double wave = 20.0 * um;  ///< the surface's slope reaches 0.52
constexpr auto elements = "bilinear elements with vertex quadrature on parallelograms";

/// What one study solves.
struct Problem {
    Scene scene;
    HeatedSolid solid;
};

Problem ap(int cells, double clustering) {
    return {heated_block(ammonium_perchlorate(), cells, clustering), heated_block(reference::ap())};
}

Problem on_a_slope(int cells) {
    Problem problem = ap(cells, clustered);
    problem.solid.surface_wave = wave;
    return problem;
}

PrescribedHeat conduction(int cells) {
    const Problem flat = ap(cells, 0.0);
    return manufactured(flat.scene, flat.solid);
}

PrescribedHeat slope(int cells) {
    const Problem sloped = on_a_slope(cells);
    return manufactured(sloped.scene, sloped.solid);
}

PrescribedHeat convection(int cells) {
    Problem carried = on_a_slope(cells);
    carried.solid.speed = 0.45 * cm / s;
    return manufactured(carried.scene, carried.solid);
}

PrescribedHeat moving_grid(int cells) {
    Problem moving = on_a_slope(cells);
    moving.solid.regression_rate = 0.45 * cm / s;
    moving.solid.frequency = 500.0 / s;
    return manufactured(moving.scene, moving.solid);
}

PrescribedHeat burning_surface(int cells) {
    Problem hot = on_a_slope(cells);
    hot.solid.rise = 500.0;
    return burning(hot.scene, hot.solid, reference::ap());
}

reports::Study study(
    const std::string& what, PrescribedHeat (*problem)(int cells),
    const std::vector<std::string>& terms, const std::string& reason,
    int (*steps)(int cells) = [](int) { return steady_steps; }) {
    reports::Study study("heat, " + what);
    study.refines("cells", {32, 64, 128, 256})
        .measure([=](int cells) {
            return error_of_temperature(advance(problem(cells), steps(cells)), 1.0 / cells);
        })
        .covers(terms)
        .gate("T", Norm::L2, expect(2.0).within(0.1), reason)
        .gate("T", Norm::Linf, expect(2.0).within(0.1), reason + ", at the worst node too");
    return study;
}

std::vector<reports::Study> studies() {
    using namespace term;
    return {
        study("conduction", conduction, {heat_conduction}, "the five-point stencil"),
        study("conduction below a slope", slope, {heat_conduction, term::slope, clustering},
              elements),
        study("convection", convection, {heat_convection, term::slope, clustering},
              "centred convection at the vertices"),
        study("moving grid", moving_grid,
              {heat_storage, heat_convection, grid_motion, term::slope, clustering, time_step},
              "Crank-Nicolson, motion at the middle of a step, dt as h",
              [](int cells) { return cells / 16; }),
        study("burning surface", burning_surface, {gas_flux, reaction_flux, term::slope},
              "the trapezium rule along the surface, as many nodes as the grid"),
    };
}

const Registered here{{.name = "heat",
                       .figure = "-",
                       .shows = "each term of the heat equation against a manufactured temperature",
                       .cost = {.verify = 15.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
