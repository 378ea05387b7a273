#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/study.hpp"

namespace crawford::reports {

/// One grid of one study, to be run.
struct GridJob {
    const Study* study;
    int grid;
    double cost;  ///< Expected seconds, or any measure that is the same for all jobs
};

/// The run of one grid: a measurement, or why there is none.
struct GridRun {
    int grid;
    std::optional<Measurement> measurement;
    std::string failure;
    double seconds;
};

/// Runs every job once, the dearest first so that it does not wait for the cheap ones, on as many
/// threads as the machine has cores. One queue feeds them all: a study does not keep a core to
/// itself. Returned in the order of `jobs`.
std::vector<GridRun> run_grids(const std::vector<GridJob>& jobs, const OnProgress& on_progress);

}  // namespace crawford::reports
