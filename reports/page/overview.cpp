#include "reports/page/overview.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/judgement.hpp"
#include "reports/page/gate_card.hpp"
#include "reports/page/manifest.hpp"
#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

std::string verdict(const Verification& v) {
    if (v.fell_short()) return "fell short";
    return v.passed() ? "passed" : "not gated";
}

std::string style(const Verification& v) {
    if (v.fell_short()) return "fail";
    return v.passed() ? "pass" : "open";
}

Html shortcomings(const Verification& v) {
    Html items;
    for (std::size_t i = 0; i < v.gates.size(); ++i)
        if (v.gates[i].fell_short())
            items += element("li", {},
                             link(anchor_of_gate(i), v.gates[i].study + ": " + title(v.gates[i])) +
                                 ": " + v.gates[i].failure);
    const auto gaps = v.whole ? v.coverage().gaps() : std::vector<std::string>{};
    for (const auto& gap : gaps)
        items += element("li", {}, link("coverage", "coverage") + ": " + gap);
    if (items.empty()) return {};
    return element("ul", {{"class", "shortcomings"}}, items);
}

Html number_cell(std::size_t count, const std::string& style) {
    const std::string shown = count == 0 ? "" : std::to_string(count);
    return element("td", {{"class", "count " + (count == 0 ? "" : style)}}, shown);
}

/// The name of a study without that of its entry, which stands beside it.
std::string short_name(const std::string& study, const std::string& entry) {
    return study.starts_with(entry + ", ") ? study.substr(entry.size() + 2) : study;
}

/// The studies of an entry as links, coloured by how they have come out.
Html links_to_studies(const Verification& v, const std::string& entry) {
    Html links;
    for (const auto& study : v.studies) {
        if (study.entry != entry || study.name == entry) continue;
        std::string style;
        for (const auto& gate : v.gates)
            if (gate.study == study.name && gate.fell_short()) style = "fail";
        if (!links.empty()) links += " \u00b7 ";
        links += element("span", {{"class", style}},
                         link(anchor_of_study(study.name), short_name(study.name, entry)));
    }
    return links;
}

Html entry_row(const Verification& v, const std::string& entry) {
    const auto count = reports::count(gates_of(v, entry));
    double seconds = 0.0;
    for (const auto& study : v.studies)
        if (study.entry == entry) seconds += study.seconds;
    return element("tr", {},
                   element("td", {}, link(anchor_of_entry(entry), entry)) +
                       element("td", {}, badge(mark(count))) + number_cell(count.passed, "pass") +
                       number_cell(count.failed, "fail") + number_cell(count.not_gated, "open") +
                       element("td", {{"class", "count"}}, duration(seconds)) +
                       element("td", {{"class", "facts"}}, links_to_studies(v, entry))) +
           "\n";
}

}  // namespace

std::string anchor_of_entry(const std::string& name) {
    return anchor("entry-", name);
}

std::string anchor_of_study(const std::string& name) {
    return anchor("study-", name);
}

std::vector<std::string> entries_of(const Verification& v) {
    std::vector<std::string> entries;
    for (const auto& study : v.studies)
        if (std::ranges::find(entries, study.entry) == entries.end())
            entries.push_back(study.entry);
    return entries;
}

std::vector<GateResult> gates_of(const Verification& v, const std::string& entry) {
    std::vector<std::string> studies;
    for (const auto& study : v.studies)
        if (study.entry == entry) studies.push_back(study.name);
    std::vector<GateResult> gates;
    for (const auto& gate : v.gates)
        if (std::ranges::find(studies, gate.study) != studies.end()) gates.push_back(gate);
    return gates;
}

Html headline(const Verification& v) {
    return element("header", {},
                   element("h1", {},
                           "Crawford: verification " +
                               element("span", {{"class", "mark " + style(v)}}, verdict(v))) +
                       element("p", {{"class", "count-of-all"}},
                               text(count(v.gates)) +
                                   fmt::format(", {} studies", entries_of(v).size())) +
                       circumstances(v.manifest) + shortcomings(v)) +
           "\n";
}

Html table_of_studies(const Verification& v) {
    Html rows = row("th", {"study", "", "pass", "fail", "not gated", "CPU time", "consists of"});
    for (const auto& entry : entries_of(v)) rows += entry_row(v, entry);
    return element("section", {{"id", "studies"}},
                   element("h2", {}, "Studies") +
                       element("div", {{"class", "wide"}},
                               element("table", {{"class", "studies"}}, rows))) +
           "\n";
}

}  // namespace crawford::reports::page
