/// The pictures of an ensemble: means with their confidence intervals.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/ensemble.hpp"

namespace crawford::reports {

/// Against pressure, and against area fraction where there is more than one: a panel a quantity, a
/// curve for all that else is alike. Written to `out`/figures, with the numbers as CSV.
/// \returns the pictures, none where nothing is done
/// \throws FigureFailed
std::vector<std::filesystem::path> draw_ensemble(const Ensemble& ensemble,
                                                 const std::filesystem::path& out,
                                                 const std::string& revision);

}  // namespace crawford::reports
