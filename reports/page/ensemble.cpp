#include "reports/page/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/page/document.hpp"
#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

constexpr int digits = 5;  // intervals are parts of a per cent

Html conditions_head(std::vector<Html> more) {
    std::vector<Html> head{"area fraction", "pressure [MPa]", "readings",
                           "grid",          "burnt [ms]",     "counted from [ms]"};
    head.insert(head.end(), more.begin(), more.end());
    return element("thead", {}, row("th", head));
}

std::vector<Html> conditions_cells(const Conditions& c) {
    return {number(c.area_fraction, 4),
            number(1e-6 * c.pressure, 4),
            c.readings,
            fmt::format("{}\u00a0×\u00a0{}", c.columns, c.rows),
            number(1e3 * c.end, 4),
            number(1e3 * c.after, 4)};
}

Html table(const Html& rows) {
    return styled("div", "wide", styled("table", "grounds", rows)) + "\n";
}

std::string in_percent(double half_width, double mean) {
    if (std::isnan(half_width) || mean == 0.0) return "-";
    return fmt::format("{:.2g} %", 100.0 * half_width / std::abs(mean));
}

Html point_row(const EnsemblePoint& point, std::size_t quantity) {
    const Spread& found = point.spreads[quantity];
    std::vector<Html> cells = conditions_cells(point.conditions);
    cells.insert(cells.end(),
                 {found.count == point.burns ? fmt::format("{}", found.count)
                                             : fmt::format("{} of {}", found.count, point.burns),
                  number(found.mean, digits), number(found.standard_deviation),
                  "± " + number(found.half_width), in_percent(found.half_width, found.mean),
                  point.needed[quantity] ? std::to_string(*point.needed[quantity]) : "-"});
    return row("td", cells);
}

/// Empty where no burn has the quantity.
Html quantity_section(const Ensemble& ensemble, std::size_t quantity) {
    const auto& [name, symbol, unit] = ensemble_quantities[quantity];
    const auto has = [&](const EnsemblePoint& p) { return p.spreads[quantity].count > 0; };
    if (std::ranges::none_of(ensemble.points, has)) return {};
    const std::string in = std::string(unit) == "-" ? "" : fmt::format(" [{}]", unit);
    Html rows = conditions_head(
        {"packs", "mean" + in, "standard deviation" + in,
         fmt::format("{:g} % confidence{}", 100.0 * ensemble.demand.confidence, in), "of the mean",
         fmt::format("packs for ± {:g} %", 100.0 * ensemble.demand.interval)});
    for (const EnsemblePoint& point : ensemble.points) rows += point_row(point, quantity);
    return element("h3", {}, name) + table(rows);
}

Html lost_section(const Ensemble& ensemble) {
    Html rows = conditions_head({"seed", "state", "reason"});
    bool is_empty = true;
    for (const EnsembleBurn& burn : ensemble.burns) {
        if (burn.is_done()) continue;
        is_empty = false;
        std::vector<Html> cells = conditions_cells(burn.conditions);
        cells.insert(cells.end(), {burn.seed, burn.state, burn.reason});
        rows += row("td", cells);
    }
    if (is_empty) return {};
    return element("h2", {}, "Burns that are not done") +
           element("p", {},
                   "They are points of the ensemble and not of its means: what makes a burn fail "
                   "may well be what would have moved the mean.") +
           table(rows);
}

Html summary(const Ensemble& ensemble, const EnsemblePage& page) {
    const auto done = std::ranges::count_if(ensemble.burns, &EnsembleBurn::is_done);
    Html html = styled("p", "count-of-all",
                       fmt::format("{} of {} burns done, {} points", done, ensemble.burns.size(),
                                   ensemble.points.size()));
    html += element(
        "p", {},
        fmt::format("Each point is a mean over packs that differ in nothing but the seed. The "
                    "interval is Student's, {:g} %: it holds the mean of all packs, of this grid "
                    "and step, if they are normally distributed. It says nothing of the error of "
                    "grid, step or model. Rates are means over the time counted, temperature and "
                    "strain the largest in it.",
                    100.0 * ensemble.demand.confidence));
    if (page.solvers.size() > 1)
        html += styled("p", "fail",
                       fmt::format("The burns are of {} different solvers: their sources, "
                                   "compilers or flags differ. Burn them anew before you compare.",
                                   page.solvers.size()));
    return html;
}

Html remarks(const EnsemblePage& page) {
    Html items;
    for (const std::string& remark : page.remarks) items += element("li", {}, remark);
    if (items.empty()) return {};
    return element("h2", {}, "What the solver remarks of them") + element("ul", {}, items);
}

Html pictures(const EnsemblePage& page) {
    Html html;
    for (const std::string& file : page.pictures)
        html += element("figure", {},
                        element("img", {{"src", file}, {"alt", "means against conditions"}}) +
                            element("figcaption", {}, link_to(file, file)));
    return html.empty() ? html : styled("div", "pictures several", html);
}

Html origin(const EnsemblePage& page) {
    Html files;
    for (const std::string& file : page.tables) files += link_to(file, file) + " ";
    return element("h2", {}, "Numbers") + element("p", {}, files) +
           element("pre", {}, page.command) +
           styled("p", "facts", fmt::format("gathered by revision {}", page.revision));
}

}  // namespace

std::string ensemble_page(const Ensemble& ensemble, const EnsemblePage& page) {
    Html body = element("h1", {}, page.title) + summary(ensemble, page) + pictures(page);
    body += element("h2", {}, "Means, spreads, and packs needed");
    for (std::size_t q = 0; q < ensemble_quantities.size(); ++q)
        body += quantity_section(ensemble, q);
    body += lost_section(ensemble) + remarks(page) + origin(page);
    return document(page.title, body);
}

}  // namespace crawford::reports::page
