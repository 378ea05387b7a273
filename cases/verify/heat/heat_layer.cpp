/// # Travelling boundary layer: does a burning column find the exact thermal layer and keep it?
///
/// AP without mechanics regresses at 0.45 cm/s under 200 cal/(s cm2), of which pyrolysis absorbs a
/// fifth. In the frame of the surface that is an exponential (reference/travelling_layer.hpp), and
/// on the way there, from a cold solid, an expression in error functions. One column on the grid
/// that scenes burn on, where the finest cell is a quarter of the mean.
///
/// Steady, no time error is left: 8000 steps of 0.1 ms relax the slowest part of the start, which
/// decays as exp(-r_b^2 t/(4 D)), by 13 orders. Then twenty steps more must change nothing. On the
/// way, from 1 ms to 5 ms, dt falls with h.

#include <algorithm>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/heat/prescribed_heat.hpp"
#include "reference/material.hpp"
#include "reference/travelling_layer.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;
using reports::expect;
using reports::Norm;

constexpr double depth = 480.0 * um;
constexpr double burn_rate = 0.45 * cm / s;
constexpr double flame = 200.0 * cal / (s * cm2);
constexpr auto drift = "largest change in twenty steps more [K]";

reference::TravellingLayer layer() {
    const reference::Material ap = reference::ap();
    return reference::TravellingLayer({.conductivity = ap.thermal_conductivity,
                                       .capacity = ap.density * ap.specific_heat,
                                       .regression_rate = burn_rate,
                                       .flux = flame + ap.heat_of_reaction * ap.density * burn_rate,
                                       .cold_temperature = 300.0});
}

PrescribedHeat column(int cells) {
    PrescribedHeat heat{.scene = heated_block(ammonium_perchlorate(), cells, 2.0)};
    heat.scene.domain.nx = 1;
    heat.scene.domain.depth = depth;
    heat.scene.physics.regression = Regression::fixed;
    heat.scene.surface = {.heat_flux = {flame}, .burn_rate = burn_rate};
    heat.surface = [](double, double t) { return -burn_rate * t; };
    heat.surface_rate = [](double, double) { return -burn_rate; };
    return heat;
}

reports::Measurement steady(int cells) {
    constexpr double step = 0.1 * ms;
    constexpr int steps = 8000;
    constexpr int more = 20;
    PrescribedHeat heat = column(cells);
    heat.temperature = [exact = layer()](double, double y, double t) {
        return exact.steady(y + burn_rate * t, depth);
    };
    const auto after = [&](int count) {
        heat.scene.time.end = count * step;
        return advance(heat, count);
    };
    const FoundHeat found = after(steps);
    const FoundHeat later = after(steps + more);
    double change = 0.0;
    for (size_t k = 0; k < found.temperature.size(); ++k)
        change = std::max(change, std::abs(later.temperature[k] - found.temperature[k]));
    return error_of_temperature(found, 1.0 / cells).value(drift, change);
}

reports::Measurement heating(int cells) {
    PrescribedHeat heat = column(cells);
    heat.temperature = [exact = layer()](double, double y, double t) {
        return exact.heating(y + burn_rate * t, t);
    };
    heat.start = 1.0 * ms;
    heat.scene.time.end = 5.0 * ms;
    return error_of_temperature(advance(heat, cells / 2), 1.0 / cells);
}

reports::Study study(const std::string& what, const reports::MeasureGrid& measure) {
    reports::Study study("heat-layer, " + what);
    study.refines("rows", {32, 64, 128, 256})
        .measure(measure)
        .gate("T", Norm::L2, expect(2.0).within(0.1), "centred differences, clustered smoothly")
        .gate("T", Norm::Linf, expect(2.0).within(0.1), "the same at the surface");
    return study;
}

std::vector<reports::Study> studies() {
    using namespace term;
    const std::vector<std::string> layer{heat_convection, heat_conduction, gas_flux,
                                         reaction_flux,   grid_motion,     clustering};
    std::vector<std::string> transient = layer;
    transient.insert(transient.end(), {heat_storage, time_step});
    return {study("steady", steady)
                .covers(layer)
                .bound(drift, 128, at_most(1e-10), "round-off of 900 K, 1e-13, a thousand times"),
            study("heating", heating).covers(transient)};
}

const Registered here{{.name = "heat-layer",
                       .figure = "-",
                       .shows = "travelling thermal layer, steady and on its way there",
                       .cost = {.verify = 5.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
