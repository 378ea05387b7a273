/// The plot of a gate: errors against the grid.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/figure.hpp"
#include "reports/order.hpp"

namespace crawford::reports {

/// One line of a convergence plot.
struct ConvergenceCurve {
    std::string label;
    Convergence convergence;
    double expected;  ///< Draws a reference slope of this order; NaN draws none
};

/// Axis labels of a convergence plot.
struct ConvergenceAxes {
    std::string h = "cell size h";
    std::string error = "error / size of the truth";
};

/// Errors, each divided by the size of its truth, against h on logarithmic axes, with one reference
/// slope for each expected order: <name>.svg in `out`/figures, its numbers as CSV beside it. Errors
/// that are not positive are left out.
/// \throws FigureFailed; std::invalid_argument if no curve has a point.
std::filesystem::path draw_convergence(const std::string& name, const std::filesystem::path& out,
                                       const std::string& heading,
                                       const std::vector<ConvergenceCurve>& curves,
                                       const Caption& caption, const ConvergenceAxes& axes = {});

}  // namespace crawford::reports
