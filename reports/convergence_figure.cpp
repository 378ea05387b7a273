#include "reports/convergence_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace crawford::reports {
namespace {

/// The two columns of a line, in the order of the levels.
struct Line {
    std::vector<double> h, error;
};

Line drawable(const Convergence& convergence) {
    Line line;
    const double scale = convergence.scale() > 0.0 ? convergence.scale() : 1.0;
    for (const auto& level : convergence.levels()) {
        if (!(level.error > 0.0 && std::isfinite(level.error) && level.h > 0.0)) continue;
        line.h.push_back(level.h);
        line.error.push_back(level.error / scale);
    }
    return line;
}

/// A line of the given order through a point at half the height of the lowest curve's coarsest
/// error.
Line slope(double order, const Line& lowest) {
    const double h0 = lowest.h.front(), e0 = 0.5 * lowest.error.front();
    const double h1 = lowest.h.back();
    return {{h0, h1}, {e0, e0 * std::pow(h1 / h0, order)}};
}

void add(Figure& figure, const std::string& table, const Line& line) {
    figure.table(table, {{"h", "as stated", line.h}, {"error", "relative", line.error}});
}

}  // namespace

std::filesystem::path draw_convergence(const std::string& name, const std::filesystem::path& out,
                                       const std::string& heading,
                                       const std::vector<ConvergenceCurve>& curves,
                                       const Caption& caption, const ConvergenceAxes& axes) {
    Figure figure(name, out, "reports/convergence.gp");
    std::map<double, Line> lowest;  // for each expected order, the curve that lies lowest
    int count = 0;
    for (const auto& curve : curves) {
        const auto line = drawable(curve.convergence);
        if (line.h.empty()) continue;
        ++count;
        add(figure, fmt::format("curve_{}", count), line);
        figure.set(fmt::format("title_{}", count), curve.label);
        if (std::isnan(curve.expected)) continue;
        const auto [at, fresh] = lowest.try_emplace(curve.expected, line);
        if (!fresh && line.error.front() < at->second.error.front()) at->second = line;
    }
    if (count == 0) throw std::invalid_argument(name + ": no error to draw");

    int slopes = 0;
    for (const auto& [order, line] : lowest) {
        ++slopes;
        add(figure, fmt::format("slope_{}", slopes), slope(order, line));
        figure.set(fmt::format("slope_title_{}", slopes), fmt::format("order {:g}", order));
    }
    figure.set("curves", count).set("slopes", slopes).set("heading", heading);
    figure.set("h_label", axes.h).set("error_label", axes.error).caption(caption);
    return figure.draw().front();
}

}  // namespace crawford::reports
