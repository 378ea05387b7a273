#include "reports/page/ledger_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

/// A cell that says what it is where columns do not fit.
Html cell(const char* label, const Html& content) {
    return element("td", {{"data-label", label}}, element("div", {}, content));
}

Html aside(const Html& text) {
    return text.empty() ? Html() : styled("div", "facts", text);
}

/// By how much ours is off, and what its uncertainty consists of.
std::string doubts(const LedgerRow& row) {
    std::string text;
    if (row.value && row.paper_value && *row.paper_value != 0.0)
        text = percent_off(*row.value, *row.paper_value);
    if (!row.value) return text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    const auto& u = row.uncertainty;
    if (!u.total())
        add("uncertainty not studied");
    else if (*u.total() == 0.0)
        add("no numerical uncertainty");
    else
        for (const auto& [name, part] :
             {std::pair("grid", u.grid), std::pair("step", u.step), std::pair("packs", u.packs)})
            if (part != 0.0)
                add(fmt::format("{} {}", name, part ? number(*part, 2) : "not studied"));
    return text;
}

Html claim_row(const LedgerRow& row, const std::string& anchor, bool has_page) {
    const Html entry = row.entry.empty()
                           ? Html()
                           : link_to(has_page ? row.entry + ".html" : std::string(), row.entry);
    const Html cells =
        cell("claim", row.claim + " " + element("a", {{"href", "#" + anchor}}, "#")) +
        cell("where", row.where + aside(entry)) +
        cell("paper", with_unit(row.paper, row.paper_value ? row.unit : "")) +
        cell("ours", ours(row) + aside(doubts(row))) + cell("reading", row.reading) +
        cell("verdict", mark(row.standing) + aside(row.why));
    return element("tr", {{"id", anchor}}, cells) + "\n";
}

}  // namespace

std::vector<std::string> anchors_of(const std::vector<LedgerRow>& rows) {
    std::vector<std::string> anchors;
    std::set<std::string> taken;
    for (const auto& row : rows) {
        const auto plain = anchor("claim-", row.where + ' ' + row.claim);
        auto name = plain;
        for (int k = 2; !taken.insert(name).second; ++k) name = fmt::format("{}-{}", plain, k);
        anchors.push_back(name);
    }
    return anchors;
}

Html mark(Standing standing) {
    switch (standing) {
        case Standing::reproduced:
            return styled("span", "mark pass", "reproduced");
        case Standing::other_reading:
            return styled("span", "mark open", "another reading");
        case Standing::not_reproduced:
            return styled("span", "mark fail", "not reproduced");
    }
    return {};
}

std::string ours(const LedgerRow& row) {
    const auto total = row.value ? row.uncertainty.total() : std::nullopt;
    return with_unit(
        total.value_or(0.0) > 0.0 ? row.ours + " \u00b1 " + number(*total, 2) : row.ours,
        row.value ? row.unit : "");
}

Html table_of_claims(const std::vector<LedgerRow>& rows, const std::vector<std::string>& pages) {
    const auto anchors = anchors_of(rows);
    Html body;
    for (std::size_t k = 0; k < rows.size(); ++k)
        body +=
            claim_row(rows[k], anchors[k], std::ranges::find(pages, rows[k].entry) != pages.end());
    return element("section", {{"id", "claims"}},
                   element("h2", {}, "Claims") +
                       styled("table", "ledger",
                              element("thead", {},
                                      row("th", {"claim", "where", "paper", "ours", "reading",
                                                 "verdict"})) +
                                  element("tbody", {}, body))) +
           "\n";
}

}  // namespace crawford::reports::page
