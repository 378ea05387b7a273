/// A table of discs, as read_discs() reads it.
#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace crawford {

/// CSV with the header "x [m],y [m],radius [m]", after comment rows with the discs' source and
/// period. Every digit is there: read again they are the same numbers, which other units would not
/// keep.
std::string discs_csv(const Discs&);

}  // namespace crawford
