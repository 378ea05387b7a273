#include "reports/page/gate_card.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/page/plot.hpp"
#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

bool in_the_fit(const GateResult& gate, int grid) {
    return gate.kind == GateKind::bound || (grid >= gate.coarsest && grid <= gate.finest);
}

/// Grid by grid: h, the error (or the value), and the order that led to it.
Html numbers(const GateResult& gate) {
    if (gate.grids.empty()) return {};
    const bool errors = gate.kind == GateKind::order;
    const auto& found = errors ? gate.errors : gate.values;
    Html rows = row("th", errors ? std::vector<Html>{"grid", "h", "error", "order"}
                                 : std::vector<Html>{"grid", "h", "value"});
    for (std::size_t i = 0; i < gate.grids.size() && i < found.size(); ++i) {
        std::vector<Html> cells{std::to_string(gate.grids[i]), number(gate.h[i]),
                                number(found[i], errors ? 4 : 7)};
        if (errors)
            cells.emplace_back(i == 0 ? std::string()
                                      : fmt::format("{:.2f}", gate.pairwise[i - 1]));
        rows += row("td", cells, in_the_fit(gate, gate.grids[i]) ? "" : "aside");
    }
    return element("table", {{"class", "numbers"}}, rows);
}

/// The number that is judged, and how sure it is.
Html finding(const GateResult& gate) {
    Html html;
    if (gate.kind == GateKind::order) {
        html += element(
            "strong", {},
            "order " + (std::isnan(gate.fit) ? number(gate.fit) : fmt::format("{:.3f}", gate.fit)));
        html += fmt::format(" on grids {} to {}, {}", gate.coarsest, gate.finest, gate.verdict);
    } else {
        html += element("strong", {}, number(gate.value, 6));
        html += ", " + gate.verdict;
    }
    const auto& limit = gate.limit;
    if (std::isnan(limit.value)) return element("p", {}, html);
    html += fmt::format("; {} at h \u2192 0: {}, grid uncertainty {} (safety factor {:g})",
                        gate.kind == GateKind::order ? "error" : "value",
                        number(limit.value, gate.kind == GateKind::order ? 3 : 6),
                        number(limit.uncertainty), limit.safety);
    return element("p", {}, html);
}

Html heading(const GateResult& gate) {
    return element("h4", {},
                   badge(mark(gate)) + " " + title(gate) + " " +
                       element("span", {{"class", "demand"}}, demand(gate)));
}

}  // namespace

Html badge(Mark mark) {
    return element("span", {{"class", "mark " + style_of(mark)}}, word(mark));
}

std::string anchor_of_gate(std::size_t index) {
    return "gate-" + std::to_string(index + 1);
}

Html gate_card(const GateResult& gate, std::size_t index) {
    Html text = heading(gate);
    if (!gate.passed) text += element("p", {{"class", style_of(mark(gate))}}, gate.failure);
    if (gate.gated) text += finding(gate);
    text += element("p", {{"class", "reason"}}, "because " + gate.reason);
    text += element(
        "div", {{"class", "evidence"}},
        numbers(gate) + (gate.kind == GateKind::order ? order_plot(gate) : bound_plot(gate)));
    return element("article",
                   {{"id", anchor_of_gate(index)}, {"class", "gate " + style_of(mark(gate))}},
                   text) +
           "\n";
}

}  // namespace crawford::reports::page
