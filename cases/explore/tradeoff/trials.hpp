/// What is tried: one knob at a time about a usual setting, and settings that save in several ways.
#pragma once

#include <vector>

#include "cases/explore/tradeoff/trial.hpp"
#include "cases/registry.hpp"

namespace crawford::tradeoff {

std::vector<Subject> subjects(Fidelity fidelity);

/// Of all subjects, those that the others are held against first.
std::vector<Trial> trials(Fidelity fidelity);

}  // namespace crawford::tradeoff
