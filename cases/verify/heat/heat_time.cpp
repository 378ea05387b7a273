/// # Heat in time: of what order is a step?
///
/// Temperature and velocity are linear in height and the surface is level, so that bilinear
/// elements on eight cells carry them without error in space: all that is left is the error in
/// time. A "grid" here is a number of steps. Only the split stress work is not free of space: it
/// takes DT/Dt at the centres of cells, and so many of those that their error is below one per cent
/// of that in time.
///
/// Crank-Nicolson is of second order, and stays so with the flux that pyrolysis absorbs, which the
/// step takes linearised about its start. What lags by a step makes it first order: the motion of
/// surface and solid, which a burning step knows only at its start; the stress work, taken at the
/// old temperature; and the rate DT/Dt of the adiabatic split, that of the step before. So the
/// paper's step is of first order as a whole, and this says by which of its parts.

#include <functional>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/heat/prescribed_heat.hpp"
#include "reference/material.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::expect;
using reports::Norm;

/// What one study solves.
struct Problem {
    Scene scene;
    reference::HeatedSolid solid;
};

Problem linear(const Material& material, const reference::Material& same) {
    Problem problem{heated_block(material, 8, 0.0), heated_block(same)};
    problem.scene.domain.nx = 1;
    problem.scene.time.end = 4.0 * ms;
    problem.solid.linear = true;
    problem.solid.frequency = 500.0 / s;
    problem.solid.regression_rate = 0.45 * cm / s;
    problem.solid.speed = 0.1 * cm / s;
    return problem;
}

PrescribedHeat rigid() {
    const Problem ap = linear(ammonium_perchlorate(), reference::ap());
    return manufactured(ap.scene, ap.solid);
}

PrescribedHeat motion_at_the_start() {
    PrescribedHeat heat = rigid();
    heat.motion_at = 0.0;
    return heat;
}

PrescribedHeat burning() {
    Problem ap = linear(ammonium_perchlorate(), reference::ap());
    ap.solid.rise = 500.0;
    return burning(ap.scene, ap.solid, reference::ap());
}

PrescribedHeat expanding(Coupling coupling) {
    const reference::Material same = reference::binder();
    Problem binder = linear(htpb_binder(), same);
    binder.scene.physics.mechanics = true;
    binder.scene.numerics.coupling = coupling;
    binder.scene.domain.ny = 64;
    binder.solid.stress_work = 3.0 * same.thermal_expansion * same.bulk_modulus;
    return manufactured(binder.scene, binder.solid);
}

reports::Study study(const std::string& what, const std::function<PrescribedHeat()>& problem,
                     double order, const std::vector<std::string>& terms,
                     const std::string& reason) {
    reports::Study study("heat-time, " + what);
    study.refines("steps", {128, 256, 512, 1024})
        .measure([problem](int steps) {
            return error_of_temperature(advance(problem(), steps), 1.0 / steps);
        })
        .covers(terms)
        .gate("T", Norm::Linf, expect(order).within(0.1), reason);
    return study;
}

std::vector<reports::Study> studies() {
    using namespace term;
    const auto lagged = [] { return expanding(Coupling::lagged); };
    const auto split = [] { return expanding(Coupling::adiabatic); };
    return {
        study("Crank-Nicolson", rigid, 2.0, {heat_storage, heat_convection, grid_motion, time_step},
              "motion at the middle of a step"),
        study("burning surface", burning, 2.0, {reaction_flux, time_step},
              "absorbed heat linearised about the start of a step, taken at its middle"),
        study("motion at the start", motion_at_the_start, 1.0, {grid_motion, time_step},
              "as a burning step must: it does not know where the surface will be"),
        study("stress work, lagged", lagged, 1.0, {stress_work, time_step},
              "beta T div v with the temperature at the start"),
        study("stress work, split", split, 1.0, {stress_work, time_step},
              "DT/Dt of the step before"),
    };
}

const Registered here{{.name = "heat-time",
                       .figure = "-",
                       .shows = "order in time of the heat step, part by part",
                       .cost = {.verify = 1.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
