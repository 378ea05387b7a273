/// # Heat, stress work: does -beta T div v cool as much as it should, under every reading?
///
/// Binder moves and expands as prescribed, below a sloped surface that sinks, on a clustered grid;
/// its temperature is manufactured as in the study `heat`. Everything is steady in the frame of the
/// surface. That matters here: the stress work lags by a step, an error of first order in time
/// (heat-time measures it) which a steady field does not show.
///
/// Split adiabatically, the step moves beta^2 T/K DT/Dt to its left side and takes it back on the
/// right with the DT/Dt that the step itself has found before: a rate that is wrong, or a capacity
/// that is not the one taken back, stays as an error that no grid makes smaller. Binder couples
/// strongly: beta T div v reaches some three times the conducted heat.

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

constexpr int steps = 4;

/// What one study solves.
struct Problem {
    Scene scene;
    reference::HeatedSolid solid;
};

Problem deforming(int cells, Coupling coupling) {
    const reference::Material binder = reference::binder();
    Problem problem{heated_block(htpb_binder(), cells, 2.0), heated_block(binder)};
    problem.scene.physics.mechanics = true;
    problem.scene.numerics.coupling = coupling;
    problem.solid.surface_wave = 20.0 * um;
    problem.solid.speed = 0.1 * cm / s;
    problem.solid.regression_rate = 0.45 * cm / s;
    problem.solid.stress_work = 3.0 * binder.thermal_expansion * binder.bulk_modulus;
    return problem;
}

Problem lagged(int cells) {
    return deforming(cells, Coupling::lagged);
}

Problem split(int cells) {
    return deforming(cells, Coupling::adiabatic);
}

Problem alpha_k(int cells) {
    Problem binder = split(cells);
    binder.scene.numerics.stress_work = ThermalStress::alpha_bulk;
    binder.solid.stress_work /= 3.0;
    return binder;
}

Problem constant_volume(int cells) {
    Problem binder = split(cells);
    const double beta = binder.solid.stress_work;
    binder.scene.numerics.heat_capacity = HeatCapacity::constant_volume;
    binder.solid.capacity_slope = beta * beta / reference::binder().bulk_modulus;
    return binder;
}

reports::Study study(const std::string& what, Problem (*problem)(int cells),
                     const std::string& reason) {
    reports::Study study("heat-stress-work, " + what);
    study.refines("cells", {32, 64, 128, 256})
        .measure([problem](int cells) {
            const auto [scene, solid] = problem(cells);
            return error_of_temperature(advance(manufactured(scene, solid), steps), 1.0 / cells);
        })
        .covers({term::stress_work, term::heat_convection, term::slope, term::clustering})
        .gate("T", Norm::L2, expect(2.0).within(0.1), reason)
        .gate("T", Norm::Linf, expect(2.0).within(0.1), reason + ", at the worst node too");
    return study;
}

std::vector<reports::Study> studies() {
    return {study("lagged", lagged, "div v at the centre of a cell"),
            study("split", split, "div v and DT/Dt at the centre of a cell"),
            study("alpha K", alpha_k, "as with 3 alpha K"),
            study("capacity at constant volume", constant_volume,
                  "capacity at the mean temperature of a cell")};
}

const Registered here{{.name = "heat-stress-work",
                       .figure = "-",
                       .shows = "stress work against a manufactured temperature",
                       .cost = {.verify = 10.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
