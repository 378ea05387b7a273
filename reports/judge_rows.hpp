#pragma once

#include <vector>

#include "reports/grid_runs.hpp"
#include "reports/study.hpp"

namespace crawford::reports {

/// Judges every row of a study, in the order written, on the runs of some of its grids, coarsest
/// first. A row that needs a grid of the study's own that is not among the runs is left ungated; a
/// run that failed fails every row that needs it.
std::vector<GateResult> judge_rows(const Study& study, const std::vector<GridRun>& runs);

}  // namespace crawford::reports
