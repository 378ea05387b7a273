/// The burning sandwich with more and more columns, as the paper refines it.
#pragma once

#include <memory>
#include <vector>

#include "cases/scenes/sandwich.hpp"

namespace crawford {

/// Coarsest first; each has twice the columns of the one before. Paper: 32 to 256 columns, 96 rows
/// with clustering 2, steps of 20 us, until 0.1 s.
/// Their scenes.
std::vector<Scene> refined_scenes(Fidelity fidelity, Front front = Front::faster_side);
std::vector<std::shared_ptr<const Burn>> refined_sandwich(const Request& request,
                                                          Front front = Front::faster_side);

/// "32, 64, 128, 256 x 96, clustering 2, half modelled"
std::string grids_text(const std::vector<std::shared_ptr<const Burn>>& burns);

}  // namespace crawford
