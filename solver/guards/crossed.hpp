/// How many cells are crossed in one step.
#pragma once

#include <vector>

#include "solver/mesh/grid.hpp"
#include "solver/step/state.hpp"

namespace crawford {

/// What was crossed in one step, at most.
struct Crossed {
    double columns = 0.0, rows = 0.0;  ///< by the solid
};

class Crossing {
public:
    explicit Crossing(const Grid& grid);

    /// In the step that led to `after` from a surface `before`.
    Crossed of(const SurfaceField& before, const State& after) const;

private:
    std::vector<double> rows_in_a_metre_;  ///< at each node row, by the lower cell beside it [1/m]
    double columns_in_a_metre_;            ///< by the narrowest [1/m]
};

}  // namespace crawford
