/// The manufactured burning solid as a run of the solver: the same solid, driven by what the truth
/// says is missing.
#pragma once

#include "cases/verify/known_values.hpp"
#include "reports/study.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// The exact solution solves no grid's equations: what it lacks of them spreads in the first steps.
enum class Start {
    exact,   ///< from the exact states at t = 0 and a step before: no first step of lower order
    settled  ///< from what a few short steps make of the exact state: for differences in the step
};

struct ManufacturedBurn {
    int cells = 32;  ///< across and along
    double clustering_x = 0.0;
    int steps = 1;
    double end = 0.0;  ///< [s]
    Stepping scheme = Stepping::euler;
    Start start = Start::exact;
    Element element = Element::bbar;
    Coupling coupling = Coupling::adiabatic;
    LinearSolver solver = LinearSolver::cholmod;
};

/// Steps from the exact state at t = 0 to the end and compares: errors of T, v, stress, pressure,
/// surface, shift and F against the truth, and samples of the same for successive differences.
reports::Measurement run_manufactured(const ManufacturedBurn& burn, double h);

/// The same run, and what it gives at single places; where stress and F are asked for, no cell lies
/// beyond.
std::vector<KnownValue> values_of_manufactured(const ManufacturedBurn& burn,
                                               const std::vector<Place>& places);

}  // namespace crawford
