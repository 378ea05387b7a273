/// # Heat, mixture: how much heat does a cell store that an interface cuts?
///
/// A laminate of layers so thin that the heat evens out across them, burnt at a fixed rate under a
/// fixed flux. In the steady state what comes in goes into heating what the surface comes to,
///
///     Q = r_b (integral of rho c dx/width) (T_s - T_0),
///
/// whatever it conducts: T_s tells the mean of rho c. The layers' faces lie inside cells, and the
/// materials differ tenfold in rho c, by the root of ten in rho and in c: the mean of the product is
/// not the product of the means.

#include <cmath>
#include <numeric>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/heat/heated_laminate.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;

constexpr double period = 12.0 * um;
constexpr double layer = 4.3 * um;
constexpr double conductivity = 0.4;            // [W/(m K)]
constexpr double small = 0.5e6, large = 5.0e6;  // rho c [J/(m^3 K)]
constexpr double burn_rate = 0.45 * cm / s;
constexpr double cold = 300.0, rise = 500.0;  // [K]
constexpr double mean_capacity = (layer * large + (period - layer) * small) / period;

Scene scene(int columns) {
    Scene scene;
    scene.domain = {
        .width = period, .depth = 480.0 * um, .nx = columns, .ny = 48, .clustering = 2.0};
    scene.morphology = {
        .shape = Sandwich{layer},
        .materials = {conductor(conductivity, small), conductor(conductivity, large)}};
    for (Material& material : scene.morphology.materials) material.heat_of_reaction = 0.0;
    scene.physics = {.mechanics = false, .reference_map = false, .regression = Regression::fixed};
    scene.surface.burn_rate = burn_rate;
    const double flux = burn_rate * mean_capacity * rise;
    scene.surface.heat_flux = {flux, flux};
    scene.bottom.temperature = cold;
    scene.time.step = 0.1 * ms;
    scene.time.end = 0.3 * s;  // 4 D/r_b^2, in which it forgets its start, is 0.04 s
    return scene;
}

/// Mean of T_s - T_0 over its exact value, less 1.
double error(int columns) {
    Simulation simulation(scene(columns));
    run_to_end(simulation);
    const NodeField& temperature = simulation.state().temperature;
    double sum = 0.0;
    for (int i = 0; i < columns; ++i) sum += temperature(i, temperature.rows() - 1) - cold;
    return sum / (columns * rise) - 1.0;
}

std::vector<reports::Study> studies() {
    constexpr auto quantity = "(T_s - T_0)/exact - 1";
    reports::Study study("heat-mixture");
    study.refines("columns", {5, 10})
        .covers({term::heat_storage, term::heat_interface, term::gas_flux})
        .measure([](int columns) {
            return reports::Measurement(1.0 / columns).value(quantity, error(columns));
        })
        .bound(quantity, 10, between(-5e-3, 5e-3),
               "1.4e-3 seen, as the layers are not thin enough to be all of one temperature; "
               "4 % with mean rho times mean c");
    return {study};
}

const Registered here{{.name = "heat-mixture",
                       .figure = "-",
                       .shows = "heat that a cut cell stores",
                       .cost = {.verify = 1.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
