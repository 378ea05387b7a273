/// Only what a scene requires: columns that would be copies of others are not computed.
#pragma once

#include <string>

#include "solver/files/widening.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

struct Reduction {
    Scene asked;           ///< as it is written
    Scene scene;           ///< what is computed
    Widening widening;     ///< from that to what was asked for
    std::string left_out;  ///< in words; empty if nothing is
};

/// Everything is computed as it is written.
Reduction as_written(const Scene& scene);

/// One material in x becomes a column, a sandwich its half. What is asked for stays the same: V and
/// T to some 1e-9, the tolerances of the solvers.
Reduction reduced(const Scene& scene);

}  // namespace crawford
