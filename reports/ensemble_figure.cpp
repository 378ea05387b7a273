#include "reports/ensemble_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "reports/figure.hpp"

namespace crawford::reports {

namespace {

namespace fs = std::filesystem;

/// What stands on the x axis, and what then tells the curves apart.
struct Axis {
    std::string name, label, unit;
    std::function<double(const Conditions&)> at;
    std::function<std::string(const Conditions&)> others;
};

std::string word(double fraction) {
    return std::isnan(fraction) ? std::string("no particles")
                                : fmt::format("area fraction {:.4g}", fraction);
}

/// Grids and times are named where points differ in them.
std::string numerics(const Conditions& c, bool differ) {
    return differ ? fmt::format(", {} x {}, {:g} ms", c.columns, c.rows, 1e3 * c.end)
                  : std::string();
}

bool numerics_differ(const Ensemble& ensemble) {
    std::set<std::string> found;
    for (const EnsemblePoint& point : ensemble.points)
        found.insert(numerics(point.conditions, true));
    return found.size() > 1;
}

std::vector<Axis> axes_of(const Ensemble& ensemble) {
    const bool differ = numerics_differ(ensemble);
    return {
        {"pressure", "pressure / MPa", "MPa", [](const Conditions& c) { return c.pressure / 1e6; },
         [=](const Conditions& c) {
             return fmt::format("{}, {}{}", word(c.area_fraction), c.readings, numerics(c, differ));
         }},
        {"fraction", "area fraction of the particles", "-",
         [](const Conditions& c) { return c.area_fraction; },
         [=](const Conditions& c) {
             return fmt::format("{:g} MPa, {}{}", c.pressure / 1e6, c.readings,
                                numerics(c, differ));
         }}};
}

struct Curve {
    std::string title;
    std::vector<const EnsemblePoint*> points;
};

std::vector<Curve> curves_of(const Ensemble& ensemble, const Axis& axis) {
    std::map<std::string, Curve> curves;
    for (const EnsemblePoint& point : ensemble.points) {
        if (point.spreads.front().count == 0 || std::isnan(axis.at(point.conditions))) continue;
        const std::string title = axis.others(point.conditions);
        Curve& curve = curves[title];
        curve.title = title;
        curve.points.push_back(&point);
    }
    std::vector<Curve> found;
    for (auto& [title, curve] : curves) {
        std::ranges::sort(curve.points, {},
                          [&](const EnsemblePoint* point) { return axis.at(point->conditions); });
        found.push_back(std::move(curve));
    }
    return found;
}

/// One mean alone has an interval of no width; what it is not known by is not drawn.
std::vector<Column> columns_of(const Curve& curve, const Axis& axis) {
    std::vector<Column> columns{{axis.name, axis.unit, {}}};
    for (const EnsemblePoint* point : curve.points)
        columns.front().values.push_back(axis.at(point->conditions));
    for (std::size_t q = 0; q < ensemble_quantities.size(); ++q) {
        const auto& [name, symbol, unit] = ensemble_quantities[q];
        Column mean{fmt::format("{} mean", symbol), unit, {}};
        Column half{fmt::format("{} half-width", symbol), unit, {}};
        for (const EnsemblePoint* point : curve.points) {
            mean.values.push_back(point->spreads[q].mean);
            half.values.push_back(
                std::isnan(point->spreads[q].half_width) ? 0.0 : point->spreads[q].half_width);
        }
        columns.push_back(mean);
        columns.push_back(half);
    }
    return columns;
}

std::string grid_of(const Ensemble& ensemble) {
    const Conditions& first = ensemble.points.front().conditions;
    return numerics_differ(ensemble) ? std::string()
                                     : fmt::format("{} x {}", first.columns, first.rows);
}

/// A quantity that no burn has, as the strain where there are no mechanics, gets no panel.
bool is_there(const Ensemble& ensemble, std::size_t quantity) {
    return std::ranges::any_of(ensemble.points, [&](const EnsemblePoint& point) {
        return !std::isnan(point.spreads[quantity].mean);
    });
}

std::vector<fs::path> draw_along(const Axis& axis, const Ensemble& ensemble, const fs::path& out,
                                 const std::string& revision) {
    const auto curves = curves_of(ensemble, axis);
    std::set<double> places;
    for (const Curve& curve : curves)
        for (const EnsemblePoint* point : curve.points) places.insert(axis.at(point->conditions));
    if (curves.empty() || (axis.name != "pressure" && places.size() < 2)) return {};
    Figure figure("ensemble_" + axis.name, out);
    for (std::size_t k = 0; k < curves.size(); ++k) {
        figure.table(fmt::format("curve_{}", k + 1), columns_of(curves[k], axis));
        figure.set(fmt::format("title_{}", k + 1), curves[k].title);
    }
    const double room = places.size() > 1 ? 0.06 * (*places.rbegin() - *places.begin())
                                          : 0.5 * std::max(*places.begin(), 1e-6);
    figure.set("curves", double(curves.size()))
        .set("x_label", axis.label)
        .set("x_low", *places.begin() - room)
        .set("x_high", *places.rbegin() + room)
        .set("apart", 0.12 * room)
        .caption({.grid = grid_of(ensemble),
                  .revision = revision,
                  .note = fmt::format(
                      "bars: {:g} % confidence interval of the mean, curves set apart sideways",
                      100.0 * ensemble.demand.confidence)});
    constexpr PanelSize size{.width = 640, .height = 490};  // the legend stands below
    constexpr std::array panels{"_V", "_rate", "_T", "_strain"};
    static_assert(panels.size() == ensemble_quantities.size());
    for (std::size_t q = 0; q < panels.size(); ++q) {
        figure.set(fmt::format("has{}", panels[q]), is_there(ensemble, q) ? 1.0 : 0.0);
        if (is_there(ensemble, q)) figure.panel(panels[q], Format::svg, size);
    }
    return figure.draw();
}

}  // namespace

std::vector<fs::path> draw_ensemble(const Ensemble& ensemble, const fs::path& out,
                                    const std::string& revision) {
    std::vector<fs::path> pictures;
    for (const Axis& axis : axes_of(ensemble))
        for (const fs::path& picture : draw_along(axis, ensemble, out, revision))
            pictures.push_back(picture);
    return pictures;
}

}  // namespace crawford::reports
