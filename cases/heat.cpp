/// # Heat: is every term of the heat equation there, and of second order in space?
///
/// The temperature is made up (reference/manufactured_heat.hpp): waves in x, bent in y, different
/// at every point. A source and a surface flux, found from it by automatic differentiation, make it
/// the solution of the heat equation, so whatever the heat step returns beside it is the step's
/// error. Surface and velocity are prescribed; nothing else of the solver runs.
///
/// Each study switches on one term, so that a fault is named. All but one are steady in the frame
/// of the surface: four steps from the exact temperature then show the error in space and none in
/// time, also of the stress work, which lags by a step. The moving grid is the exception: there the
/// temperature swings, the surface sinks by 4.5 um and its wave grows, motion is taken at the middle
/// of the step, and dt falls with h: second order in both. In time alone: heat-time.

#include <cmath>

#include "cases/catalogue/prescribed_heat.hpp"
#include "cases/catalogue/registry.hpp"
#include "cases/catalogue/terms.hpp"
#include "cases/catalogue/units.hpp"
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

/// Binder that expands as it moves; compare with paper eq. 38 for beta.
Problem deforming(int cells, Coupling coupling) {
    const reference::Material binder = reference::binder();
    Problem problem{heated_block(htpb_binder(), cells, clustered), heated_block(binder)};
    problem.scene.physics.mechanics = true;
    problem.scene.numerics.coupling = coupling;
    problem.solid.surface_wave = wave;
    problem.solid.speed = 0.1 * cm / s;
    problem.solid.regression_rate = 0.45 * cm / s;
    problem.solid.stress_work = 3.0 * binder.thermal_expansion * binder.bulk_modulus;
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

PrescribedHeat lagged(int cells) {
    const Problem binder = deforming(cells, Coupling::lagged);
    return manufactured(binder.scene, binder.solid);
}

PrescribedHeat split(int cells) {
    const Problem binder = deforming(cells, Coupling::adiabatic);
    return manufactured(binder.scene, binder.solid);
}

PrescribedHeat alpha_k(int cells) {
    Problem binder = deforming(cells, Coupling::adiabatic);
    binder.scene.numerics.stress_work = ThermalStress::alpha_bulk;
    binder.solid.stress_work /= 3.0;
    return manufactured(binder.scene, binder.solid);
}

PrescribedHeat constant_volume(int cells) {
    Problem binder = deforming(cells, Coupling::adiabatic);
    binder.scene.numerics.heat_capacity = HeatCapacity::constant_volume;
    binder.solid.capacity_slope =
        binder.solid.stress_work * binder.solid.stress_work / reference::binder().bulk_modulus;
    return manufactured(binder.scene, binder.solid);
}

/// The flame's flux and what pyrolysis absorbs come from the burning law; the source of flux gives
/// only the rest.
PrescribedHeat burning_surface(int cells) {
    Problem burning = on_a_slope(cells);
    const double flame = 100.0 * cal / (units::s * cm2);
    burning.scene.physics.regression = Regression::pyrolysis;
    burning.scene.surface.heat_flux = {flame};
    burning.solid.rise = 500.0;
    PrescribedHeat heat = manufactured(burning.scene, burning.solid);
    heat.sources.heat_flux = [truth = reference::ManufacturedHeat(burning.solid), flame,
                              m = reference::ap()](double x, double, double t) {
        const double temperature = truth.temperature(x, truth.surface(x, t), t);
        const double rate =
            m.pyrolysis_prefactor * std::exp(-m.activation_temperature / temperature);
        return truth.surface_flux(x, t) - flame - m.heat_of_reaction * m.density * rate;
    };
    return heat;
}

reports::Study study(
    const std::string& what, PrescribedHeat (*problem)(int cells),
    const std::vector<std::string>& terms, const std::string& reason,
    int (*steps)(int cells) = [](int) { return steady_steps; }) {
    reports::Study study("heat, " + what);
    study.grids({32, 64, 128, 256})
        .measure([=](int cells) {
            return error_of_temperature(advance(problem(cells), steps(cells)), 1.0 / cells);
        })
        .covers(terms)
        .gate("T", Norm::L2, expect(2.0).within(0.1), reason)
        .gate("T", Norm::Linf, expect(2.0).within(0.15), reason + ", at the worst node too");
    return study;
}

std::vector<reports::Study> studies() {
    using namespace term;
    const std::vector<std::string> work{stress_work, heat_convection, term::slope, clustering};
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
        study("stress work, lagged", lagged, work, "div v at the centre of a cell"),
        study("stress work, split", split, work, "div v and DT/Dt at the centre of a cell"),
        study("stress work, alpha K", alpha_k, work, "as with 3 alpha K"),
        study("capacity at constant volume", constant_volume, work,
              "capacity at the mean temperature of a cell"),
        study("burning surface", burning_surface, {gas_flux, reaction_flux, term::slope},
              "the trapezium rule along the surface, as many nodes as the grid"),
    };
}

const Registered here{{.name = "heat",
                       .figure = "-",
                       .shows = "each term of the heat equation against a manufactured temperature",
                       .cost = {.verify = 30.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
