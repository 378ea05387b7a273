/// From the runs of a study to the judgement on each of its rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/study.hpp"

namespace crawford::reports {

/// The run on one grid: a measurement, or why there is none.
struct GridRun {
    int grid;
    std::optional<Measurement> measurement;
    std::string failure;
    double seconds;
};

/// What a record says of a study's run.
GridRun grid_run(const Study& study, const Record& record);

/// Judges every row of a study, in the order written, on the runs of some of its grids, coarsest
/// first. A row that needs a grid of the study's own that is not among the runs is left ungated; a
/// run that failed fails every row that needs it.
std::vector<GateResult> judge_rows(const Study& study, const std::vector<GridRun>& runs);

}  // namespace crawford::reports
