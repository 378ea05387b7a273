/// Temperatures of the heat step at single nodes: the problems of cases/verify/heat.
#include <fmt/format.h>

#include "cases/explore/coverage/known_problem.hpp"
#include "cases/units.hpp"
#include "cases/verify/heat/heated_laminate.hpp"
#include "reference/material.hpp"

namespace crawford {

namespace {

using namespace units;
using Places = std::vector<Place>;

std::vector<KnownValue> temperatures(const PrescribedHeat& heat, int steps, const Places& places) {
    const FoundHeat found = advance(heat, steps);
    const Grid grid(heat.scene.domain);
    std::vector<KnownValue> values;
    for (const Place& place : places) {
        const NodeIndex at = node_at(grid, place);
        const auto k = size_t(at.i * (grid.rows() + 1) + at.j);
        values.push_back({fmt::format("T at {:g}, {:g} [K]", place.across, place.up),
                          found.temperature[k], found.exact[k]});
    }
    return values;
}

/// A block of AP as wide as deep, as many cells across as up.
PrescribedHeat block(int cells, double clustering,
                     const std::function<void(reference::HeatedSolid&)>& more) {
    Scene scene = heated_block(ammonium_perchlorate(), cells, clustering);
    scene.domain.nx = cells;
    reference::HeatedSolid solid = heated_block(reference::ap());
    more(solid);
    return manufactured(scene, solid);
}

const Places in_a_block{{0.25, 0.5}, {0.5, 0.75}, {0.75, 0.25}, {0.25, 1.0}, {0.5, 1.0}};
const Places in_a_laminate{{0.25, 0.5}, {0.375, 0.5}, {0.5, 0.5}, {0.25, 1.0}, {0.5, 1.0}};
const Places beside_cut_cells{{0.25, 0.5}, {0.5, 0.5}, {0.25, 1.0}, {0.5, 1.0}};

KnownProblem of_block(Fidelity fidelity, const std::string& name, double clustering, int steps,
                      const std::function<void(reference::HeatedSolid&)>& more) {
    return {"heat", "heat, " + name, 2.0, grids_of(fidelity, 4), [=](int cells) {
                return temperatures(block(cells, clustering, more), steps > 0 ? steps : cells / 4,
                                    in_a_block);
            }};
}

KnownProblem of_laminate(Fidelity fidelity, const std::string& name,
                         const reference::TwoConductors& solid) {
    return {"laminate in heat", "laminate, " + name, 2.0, grids_of(fidelity, 8), [=](int cells) {
                return temperatures(heated_laminate(solid, cells), cells / 8, in_a_laminate);
            }};
}

/// Its sides lie in another part of a cell on each grid.
KnownProblem of_cut_laminate(Fidelity fidelity, const std::string& name,
                             reference::TwoConductors solid) {
    solid.strip = 0.3 * solid.width;
    return {"cut laminate in heat", "cut laminate, " + name, 1.0, grids_of(fidelity, 4),
            [=](int cells) {
                return temperatures(heated_laminate(solid, cells), cells / 4, beside_cut_cells);
            }};
}

/// Without an error in space: a grid is a number of steps. \see cases/verify/heat/heat_time.cpp
KnownProblem in_time(Fidelity fidelity, const std::string& name, double order, double motion_at) {
    return {
        "heat in time", "heat in time, " + name, order, grids_of(fidelity, 4), [=](int steps) {
            Scene scene = heated_block(ammonium_perchlorate(), 8, 0.0);
            scene.domain.nx = 1;
            scene.time.end = 4.0 * ms;
            reference::HeatedSolid solid = heated_block(reference::ap());
            solid.linear = true;
            solid.frequency = 500.0 / s;
            solid.regression_rate = 0.45 * cm / s;
            solid.speed = 0.1 * cm / s;
            PrescribedHeat heat = manufactured(scene, solid);
            heat.motion_at = motion_at;
            return temperatures(heat, steps, {{0.0, 0.25}, {0.0, 0.5}, {0.0, 0.75}, {0.0, 1.0}});
        }};
}

}  // namespace

std::vector<KnownProblem> heat_problems(Fidelity fidelity) {
    using reference::HeatedSolid;
    constexpr double clustered = 2.0, wave = 20.0 * um;
    constexpr int steady_steps = 4, with_cells = 0;
    return {
        of_block(fidelity, "flat", 0.0, steady_steps, [](HeatedSolid&) {}),
        of_block(fidelity, "below a slope", clustered, steady_steps,
                 [](HeatedSolid& solid) { solid.surface_wave = wave; }),
        of_block(fidelity, "convection", clustered, steady_steps,
                 [](HeatedSolid& solid) {
                     solid.surface_wave = wave;
                     solid.speed = 0.45 * cm / s;
                 }),
        of_block(fidelity, "moving grid", clustered, with_cells,
                 [](HeatedSolid& solid) {
                     solid.surface_wave = wave;
                     solid.regression_rate = 0.45 * cm / s;
                     solid.frequency = 500.0 / s;
                 }),
        of_laminate(fidelity, "AP and binder", propellant_in_heat()),
        of_laminate(fidelity, "conductivity 1e-2", conductors(1e-2, 1.0)),
        of_cut_laminate(fidelity, "AP and binder", propellant_in_heat()),
        of_cut_laminate(fidelity, "conductivity 0.2", conductors(0.2, 1.0)),
        in_time(fidelity, "Crank-Nicolson", 2.0, 0.5),
        in_time(fidelity, "motion at the start", 1.0, 0.0),
    };
}

}  // namespace crawford
