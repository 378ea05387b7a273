/// # Burning sandwich: does the regression rate converge to that of the free-boundary problem?
///
/// The steady rigid sandwich has a solution of its own (reference/burning_sandwich_front.hpp): the
/// front recedes as a whole at V, and the interface comes to rest where the AP beside it burns at V
/// with a level front. The solver burns until it is nearly steady, and V is the drop of the mean
/// height from 60 to 80 ms; what is left to come until it is steady is 0.03 %.
///
/// No order is asked for. At the notch T ~ r ln r, the surface of the binder rises at 67 degrees and
/// the solid is 40 K/um hotter there: on the grids that one would use the first cell decides, and
/// bounds say what a user gets. Where the strip ends between two nodes, the temperature at the
/// crossing is known to a few K only, which costs 0.2 % more (solver/burning/surface_motion.hpp).
///
/// With the mean of the two rates at the interface the same grids are 1.8, 1.4 and 1.2 % off: that
/// reading is held to what it was found to be, so that nobody takes it for converged.

#include <cmath>
#include <future>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/burning_sandwich_front.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::Measurement;
using reports::Setting;

constexpr auto rate_error = "V, error relative to the free-boundary problem";
constexpr auto interface_error = "T_s at the interface, error [K]";
constexpr auto notch_error = "depth of the notch, error [um]";

constexpr double from = 60.0 * ms;
constexpr double to = 80.0 * ms;

/// What differs from the shipped sandwich.
struct Chosen {
    double strip = 60.0 * um;
    double clustering_x = 0.0;
    Front front = Front::faster_side;
};

Scene scene(const Setting& at, const Chosen& chosen) {
    Scene result = sandwich({"time.end=80 ms", "physics.mechanics=false",
                             "physics.reference_map=false", "time.step=40 us"});
    result.domain.nx = at.count("columns");
    std::get<Sandwich>(result.morphology.shape).strip = chosen.strip;
    result.domain.clustering_x = chosen.clustering_x;
    result.numerics.front = chosen.front;
    return result;
}

/// Drop of the mean height per time, from 60 to 80 ms [m/s].
double regression_rate(const Burn& burn) {
    double drop = 0.0;
    for (size_t k = 0; k < burn.time.size(); ++k)
        if (burn.time[k] > from + 1e-9) drop += burn.regression_rate[k] * burn.scene.time.step;
    return drop / (to - from);
}

reference::BurningSandwichFront free_boundary(double strip) {
    auto geometry = reference::paper_sandwich();
    geometry.strip = 0.5 * strip;
    return {geometry, reference::paper_flame()};
}

Measurement measure(const Setting& at, const Chosen& chosen,
                    const reference::BurningSandwichFront& exact) {
    const auto burn = kept_burn(scene(at, chosen), {});
    const Snapshot& last = burn->last;
    const int top = last.position.rows() - 1;
    const int sides = last.position.columns() - 1;
    int node = 0;  // on the interface, or the nearest
    while (last.position(node + 1, top).x() <= 0.5 * chosen.strip * (1.0 + 1e-9)) ++node;
    const double notch = last.position(sides, top).y() - last.position(node, top).y();
    return Measurement(1.0 / at.count("columns"))
        .value(rate_error, regression_rate(*burn) / exact.regression_rate() - 1.0)
        .value(interface_error, last.temperature(node, top) - exact.interface_temperature())
        .value(notch_error, (notch - exact.notch_depth()) / um);
}

struct Bound {
    int columns;
    double from, to;
    const char* reason;
};

reports::Study of(const std::string& name, const Chosen& chosen, const std::vector<Bound>& bounds) {
    // Solved once for all grids, and only if one is run.
    const auto exact = std::async(std::launch::deferred, free_boundary, chosen.strip).share();
    reports::Study study("front-sandwich, " + name);
    study.at("rows", 96L)
        .at("step", reports::Amount{40.0 * us, "s"})
        .refines("columns", {32, 64, 128})
        .measure([=](const Setting& at) { return measure(at, chosen, exact.get()); })
        .covers({term::surface_motion, term::surface_jump, term::pyrolysis, term::gas_flux,
                 term::reaction_flux});
    for (const Bound& bound : bounds)
        study.bound(rate_error, bound.columns, between(bound.from, bound.to), bound.reason);
    return study;
}

std::vector<reports::Study> studies() {
    reports::Study on_nodes =
        of("interface on a node", {},
           {{32, -5e-3, 5e-3, "what the paper's grid, half of it and twice it are good for"},
            {64, -3e-3, 3e-3, "likewise"},
            {128, -2e-3, 2e-3, "likewise"}});
    on_nodes
        .bound(interface_error, 128, between(-1.0, 1.0),
               "a balance of rates fixes it: 1 K is 1.4 % of the burn rate, the slopes give way")
        .bound(notch_error, 128, between(-1.0, 0.5), "less than a cell, 1.9 um");
    const reports::Study between_nodes =
        of("interface between nodes", {.strip = 63.0 * um},
           {{32, -5e-3, 5e-3, "0.2 % more than on a node, whatever the place in the cell"},
            {64, -5e-3, 5e-3, "likewise"},
            {128, -4e-3, 4e-3, "likewise"}});
    const reports::Study mean =
        of("mean of materials", {.front = Front::mean_of_materials},
           {{64, -1.6e-2, -1.1e-2, "too slow by the wrong node: it is the reading, not the grid"},
            {128, -1.4e-2, -0.9e-2, "likewise: twice the columns help little"}});
    const reports::Study clustered = of(
        "columns clustered about the strip", {.clustering_x = 2.0},
        {{64, -5e-4, 5e-4, "cells of 0.9 um at the notch resolve it; 0.03 % are the transient"}});
    return {on_nodes, between_nodes, clustered, mean};
}

const Registered here{{.name = "front-sandwich",
                       .figure = "-",
                       .shows = "the regression rate of a rigid sandwich against its free boundary",
                       .cost = {.verify = 30.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
