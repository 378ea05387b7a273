/// Line relaxation: columns solved exactly, one after the other, with their neighbours as they
/// stand   (paper sec. 3.2).
#pragma once

#include "solver/mesh/node_stencil.hpp"

namespace crawford {

struct Relaxation {
    int sweeps;
    double contraction;  ///< what the last sweep left of the change before it; 0 where one sufficed
};

/// Solves A x = b on the nodes above the bottom row, whose values in `x` are given; `x` enters as
/// the first guess. Columns are swept there and back until no value is further from the answer than
/// `tolerance`, and the worst no further than a thousandth of what it has changed by in all. The
/// change of a sweep is not that distance: where a sweep leaves rho of it, change rho/(1 - rho) is.
/// \throws NumericalFailure naming the column of the largest change, if 2000 sweeps do not suffice.
Relaxation relax_columns(const NodeStencil& a, const NodeField& b, NodeField& x, double tolerance);

}  // namespace crawford
