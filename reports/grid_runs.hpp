#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/study.hpp"

namespace crawford::reports {

/// The run of one grid: a measurement, or why there is none.
struct GridRun {
    int grid;
    std::optional<Measurement> measurement;
    std::string failure;
    double seconds;
};

/// Runs every grid once, the largest first so that it does not wait for the small ones, on at most
/// as many threads as the machine has. Returned in ascending order of grid.
std::vector<GridRun> run_grids(const Study& study, std::vector<int> grids,
                               const OnProgress& on_progress);

}  // namespace crawford::reports
