/// Problems with a truth, and what they give on any grid of a series: what estimates of uncertainty
/// are held against.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/registry.hpp"
#include "cases/verify/known_values.hpp"

namespace crawford {

/// One run on each grid gives all values of a problem.
struct KnownProblem {
    std::string kind;        ///< "heat", "laminate", ...
    std::string name;        ///< of all problems, one only
    double order;            ///< formal, that the study of the same is held to
    std::vector<int> grids;  ///< coarse to fine; h = 1/grid
    std::function<std::vector<KnownValue>(int grid)> measure;
};

/// Grids to a finest of 64 as draft, of 128 else, that are multiples of `step`: ratios of
/// neighbours from 1.33 to 2.
std::vector<int> grids_of(Fidelity fidelity, int step);

std::vector<KnownProblem> heat_problems(Fidelity fidelity);
std::vector<KnownProblem> slab_problems(Fidelity fidelity);
std::vector<KnownProblem> front_problems(Fidelity fidelity);
std::vector<KnownProblem> elastic_problems(Fidelity fidelity);
std::vector<KnownProblem> coupled_problems(Fidelity fidelity);
/// Values that studies measure themselves, against their truth.
std::vector<KnownProblem> study_problems(Fidelity fidelity);

/// All of them, by kind and name.
std::vector<KnownProblem> known_problems(Fidelity fidelity);

}  // namespace crawford
