/// Line relaxation: columns solved exactly, one after the other, with their neighbours as they
/// stand   (paper sec. 3.2).
#pragma once

#include "solver/mesh/node_stencil.hpp"

namespace crawford {

/// Solves A x = b on the nodes above the bottom row, whose values in `x` are given; `x` enters as
/// the first guess. Columns are swept there and back until no value changes by more than
/// `tolerance`.
/// \returns the number of sweeps.
/// \throws NumericalFailure naming the column of the largest change, if 2000 sweeps do not suffice.
int relax_columns(const NodeStencil& a, const NodeField& b, NodeField& x, double tolerance);

}  // namespace crawford
