#include "reports/page/ledger_grounds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

constexpr int digits = 5;  // what is compared must show its difference

std::string number_or_dash(const std::optional<double>& value, int shown = digits) {
    return number(value.value_or(std::nan("")), shown);
}

Html section(const std::string& id, const std::string& title, const std::string& about,
             const Html& content) {
    if (content.empty()) return {};
    return element("section", {{"id", id}},
                   element("h2", {}, title) + element("p", {}, about) + content) +
           "\n";
}

Html table(const Html& rows) {
    return styled("div", "wide", styled("table", "grounds", rows)) + "\n";
}

/// The run whose distance is smallest; runs.size() if none has one.
std::size_t nearest(const std::vector<ReadingRun>& runs) {
    std::size_t best = runs.size();
    for (std::size_t k = 0; k < runs.size(); ++k)
        if (runs[k].failure.empty() && !std::isnan(runs[k].distance) &&
            (best == runs.size() || runs[k].distance < runs[best].distance))
            best = k;
    return best;
}

/// A value, and by how much it is off the paper's.
Html compared(double value, const std::optional<double>& paper) {
    Html html = number(value, digits);
    if (paper && *paper != 0.0 && !std::isnan(value))
        html += styled("div", "facts", percent_off(value, *paper));
    return html;
}

Html reading_row(const ReadingMatrix& matrix, const ReadingRun& run, bool is_nearest) {
    Html name = run.reading;
    if (is_nearest) name += " " + styled("span", "mark pass", "nearest");
    if (!run.set.empty())
        name += styled("div", "facts",
                       element("code", {}, fmt::format("{}", fmt::join(run.set, ", "))));
    if (!run.failure.empty()) name += styled("div", "fail", run.failure);
    std::vector<Html> cells{name};
    for (std::size_t k = 0; k < matrix.quantities.size() && k < run.values.size(); ++k)
        cells.push_back(compared(run.values[k], matrix.quantities[k].paper));
    cells.emplace_back(std::isnan(run.distance) ? number(run.distance)
                                                : fmt::format("{:.2g} %", 100.0 * run.distance));
    return row("td", cells, is_nearest ? "chosen" : "");
}

Html reading_table(const ReadingMatrix& matrix) {
    std::vector<Html> head{"reading"};
    std::vector<Html> paper{"the paper"};
    for (const auto& quantity : matrix.quantities) {
        head.emplace_back(labelled(quantity.name, quantity.unit));
        paper.emplace_back(number_or_dash(quantity.paper));
    }
    head.emplace_back("distance");
    paper.emplace_back("");
    Html rows = element("thead", {}, row("th", head)) + row("td", paper, "aside");
    const auto best = nearest(matrix.runs);
    for (std::size_t k = 0; k < matrix.runs.size(); ++k)
        rows += reading_row(matrix, matrix.runs[k], k == best);
    return element("h3", {}, matrix.title) + styled("p", "facts", matrix.grid) + table(rows);
}

/// Whether two stand in one table.
bool side_by_side(const Refinement& a, const Refinement& b) {
    return a.of == b.of && a.direction == b.direction && a.size_unit == b.size_unit &&
           a.sizes == b.sizes && a.used == b.used;
}

Html refinement_row(const Refinement& r) {
    std::vector<Html> cells{labelled(r.quantity, r.unit)};
    for (const double value : r.values) cells.emplace_back(number(value, digits));
    cells.emplace_back(number_or_dash(r.order, 3));
    cells.emplace_back(number_or_dash(r.extrapolated));
    cells.emplace_back(number_or_dash(r.index, 2));
    cells.emplace_back(r.verdict);
    return row("td", cells);
}

Html refinement_head(const Refinement& r) {
    std::vector<Html> head{"quantity"};
    for (const double size : r.sizes) {
        const Html text = with_unit(number(size, 4), r.size_unit);
        head.push_back(size == r.used ? text + styled("div", "facts", "used") : text);
    }
    for (const char* name : {"order", "at size \u2192 0", "index", "verdict"})
        head.emplace_back(name);
    return element("thead", {}, row("th", head));
}

Html spread_row(const Spread& spread) {
    std::vector<Html> cells{labelled(spread.quantity, spread.unit)};
    for (const double value : spread.values) cells.emplace_back(number(value, digits));
    cells.emplace_back(number(spread.mean, digits));
    cells.emplace_back(number(spread.deviation, 2));
    return row("td", cells);
}

}  // namespace

Html readings(const std::vector<ReadingMatrix>& matrices) {
    Html tables;
    for (const auto& matrix : matrices) tables += reading_table(matrix);
    return section("readings", "Readings",
                   "Runs that differ in how the paper is read and in nothing else. The distance is "
                   "the root mean square of (ours - paper)/paper over all that the paper states.",
                   tables);
}

Html refinements(const std::vector<Refinement>& all) {
    Html tables;
    for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
        const auto& first = all[from];
        Html rows = refinement_head(first) + refinement_row(first);
        // A size that is not known equals not even itself.
        for (to = from + 1; to < all.size() && side_by_side(first, all[to]); ++to)
            rows += refinement_row(all[to]);
        tables += element("h3", {}, first.of + ", refined in " + first.direction) + table(rows);
    }
    return section("refinements", "Refinement",
                   "Index is the grid convergence index of the size that the ledger's numbers were "
                   "found with: the half width of an interval about the number, in its unit.",
                   tables);
}

Html spreads(const std::vector<Spread>& all) {
    Html tables;
    for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
        std::vector<Html> head{"quantity"};
        for (const auto seed : all[from].seeds) head.emplace_back(fmt::format("seed {}", seed));
        head.emplace_back("mean");
        head.emplace_back("deviation");
        Html rows = element("thead", {}, row("th", head));
        for (; to < all.size() && all[to].seeds == all[from].seeds; ++to)
            rows += spread_row(all[to]);
        tables += table(rows);
    }
    return section(
        "spreads", "From pack to pack",
        "The same discs, placed anew. Deviation is the standard deviation of the sample.", tables);
}

}  // namespace crawford::reports::page
