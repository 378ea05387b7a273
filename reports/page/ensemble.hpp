/// The page of an ensemble.
#pragma once

#include <string>
#include <vector>

#include "reports/ensemble.hpp"

namespace crawford::reports::page {

struct EnsemblePage {
    std::string title;
    std::vector<std::string> pictures;  ///< addresses, seen from the page
    std::vector<std::string> tables;    ///< likewise
    std::string command;                ///< that made it
    std::string revision;               ///< of the program that gathered
    std::vector<std::string> solvers;   ///< fingerprints of those that burnt: one, as a rule
    std::vector<std::string> remarks;   ///< of the solver on what it burnt, each kind once
};

/// What was burnt, the means with their intervals, how many packs it takes, and what failed.
std::string ensemble_page(const Ensemble& ensemble, const EnsemblePage& page);

}  // namespace crawford::reports::page
