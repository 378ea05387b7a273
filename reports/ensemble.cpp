#include "reports/ensemble.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/csv_table.hpp"

namespace crawford::reports {

namespace {

constexpr double megapascal = 1e6, millisecond = 1e-3;

/// NaN, of no fraction, comes last: a sort needs an order.
auto place(const Conditions& c) {
    const bool has_none = std::isnan(c.area_fraction);
    return std::tuple(has_none, has_none ? 0.0 : c.area_fraction, c.pressure, c.readings, c.columns,
                      c.rows, c.end, c.after);
}

/// Seeds are numbers of any length without leading zeros.
auto place(const EnsembleBurn& burn) {
    return std::tuple(place(burn.conditions), burn.rest, burn.seed.size(), burn.seed, burn.key,
                      !burn.is_done());
}

std::vector<EnsembleBurn> each_once(std::vector<EnsembleBurn> burns) {
    std::ranges::sort(burns, {}, [](const EnsembleBurn& burn) { return place(burn); });
    const auto again =
        std::unique(burns.begin(), burns.end(),
                    [](const EnsembleBurn& a, const EnsembleBurn& b) { return a.key == b.key; });
    burns.erase(again, burns.end());
    return burns;
}

using Burns = std::vector<EnsembleBurn>;

EnsemblePoint point_of(Burns::const_iterator first, Burns::const_iterator last,
                       const EnsembleDemand& demand) {
    EnsemblePoint point{
        .conditions = first->conditions, .burns = long(last - first), .spreads = {}, .needed = {}};
    for (std::size_t q = 0; q < ensemble_quantities.size(); ++q) {
        std::vector<double> values;
        for (auto burn = first; burn != last; ++burn)
            if (burn->is_done() && !std::isnan(burn->values[q])) values.push_back(burn->values[q]);
        point.spreads[q] = spread(values, demand.confidence);
        point.needed[q] = members_needed(point.spreads[q], demand.interval, demand.confidence);
    }
    return point;
}

std::string number(double value) {
    return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

std::string text(const std::string& words) {
    return words.empty() ? "-" : csv_cell(words);
}

std::string row(const std::vector<std::string>& cells) {
    return fmt::format("{}\n", fmt::join(cells, ","));
}

std::vector<std::string> headings_of_conditions() {
    return {"area fraction [-]", "pressure [MPa]", "readings",  "columns [-]",
            "rows [-]",          "end [ms]",       "after [ms]"};
}

std::vector<std::string> cells_of(const Conditions& c) {
    return {
        number(c.area_fraction),      number(c.pressure / megapascal), text(c.readings),
        std::to_string(c.columns),    std::to_string(c.rows),          number(c.end / millisecond),
        number(c.after / millisecond)};
}

}  // namespace

Ensemble gather(Burns burns, const EnsembleDemand& demand) {
    Ensemble ensemble{.demand = demand, .burns = each_once(std::move(burns)), .points = {}};
    const Burns& all = ensemble.burns;
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if(
            first, all.end(), [&](const EnsembleBurn& burn) { return burn.rest != first->rest; });
        ensemble.points.push_back(point_of(first, last, demand));
        first = last;
    }
    return ensemble;
}

std::string points_csv(const Ensemble& ensemble) {
    std::vector<std::string> headings = headings_of_conditions();
    headings.insert(headings.end(), {"burns [-]", "done [-]"});
    for (const EnsembleQuantity& q : ensemble_quantities) {
        headings.push_back(fmt::format("{} mean [{}]", q.symbol, q.unit));
        headings.push_back(fmt::format("{} standard deviation [{}]", q.symbol, q.unit));
        headings.push_back(fmt::format("{} half-width of {:g} % confidence interval [{}]", q.symbol,
                                       100.0 * ensemble.demand.confidence, q.unit));
        headings.push_back(fmt::format("{} packs for a half-width of {:g} % [-]", q.symbol,
                                       100.0 * ensemble.demand.interval));
    }
    std::string csv = row(headings);
    for (const EnsemblePoint& point : ensemble.points) {
        std::vector<std::string> cells = cells_of(point.conditions);
        cells.insert(cells.end(),
                     {std::to_string(point.burns), std::to_string(point.spreads.front().count)});
        for (std::size_t q = 0; q < ensemble_quantities.size(); ++q) {
            const Spread& found = point.spreads[q];
            cells.insert(cells.end(), {number(found.mean), number(found.standard_deviation),
                                       number(found.half_width),
                                       point.needed[q] ? std::to_string(*point.needed[q]) : "nan"});
        }
        csv += row(cells);
    }
    return csv;
}

std::string burns_csv(const Ensemble& ensemble) {
    std::vector<std::string> headings = headings_of_conditions();
    headings.emplace_back("seed");
    for (const EnsembleQuantity& q : ensemble_quantities)
        headings.push_back(fmt::format("{} [{}]", q.symbol, q.unit));
    headings.insert(headings.end(), {"state", "reason", "key"});
    std::string csv = row(headings);
    for (const EnsembleBurn& burn : ensemble.burns) {
        std::vector<std::string> cells = cells_of(burn.conditions);
        cells.push_back(text(burn.seed));
        for (const double value : burn.values) cells.push_back(number(value));
        cells.insert(cells.end(), {text(burn.state), text(burn.reason), burn.key});
        csv += row(cells);
    }
    return csv;
}

}  // namespace crawford::reports
