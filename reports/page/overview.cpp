#include "reports/page/overview.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/judgement.hpp"
#include "reports/page/gate_card.hpp"
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

/// A member of the manifest as text; empty if it is not there.
std::string member(const nlohmann::ordered_json& object, const char* key) {
    const auto at = object.find(key);
    if (at == object.end()) return {};
    return at->is_string() ? at->get<std::string>() : at->dump();
}

Html circumstances(const Verification& v) {
    const auto& m = v.manifest;
    std::vector<std::string> facts{"revision " + member(m, "revision")};
    if (m.contains("wall_seconds")) facts.push_back(duration(m.at("wall_seconds").get<double>()));
    if (m.contains("machine")) {
        const auto& machine = m.at("machine");
        facts.push_back(
            fmt::format("{} cores, {}", member(machine, "cores"), member(machine, "processor")));
    }
    if (m.contains("ended")) facts.push_back(member(m, "ended"));
    return element("p", {{"class", "facts"}}, fmt::format("{}", fmt::join(facts, " \u00b7 ")));
}

Html shortcomings(const Verification& v) {
    Html items;
    for (std::size_t i = 0; i < v.gates.size(); ++i)
        if (v.gates[i].fell_short())
            items += element("li", {},
                             link(anchor_of_gate(i), v.gates[i].study + ": " + title(v.gates[i])) +
                                 ": " + v.gates[i].failure);
    for (const auto& gap : v.coverage().gaps())
        items += element("li", {}, link("coverage", "coverage") + ": " + gap);
    if (items.empty()) return {};
    return element("ul", {{"class", "shortcomings"}}, items);
}

Html number_cell(std::size_t count, const std::string& style) {
    const std::string shown = count == 0 ? "" : std::to_string(count);
    return element("td", {{"class", "count " + (count == 0 ? "" : style)}}, shown);
}

Html study_row(const Verification& v, const StudyRecord& study) {
    const auto count = reports::count(gates_of(v, study.name));
    return element("tr", {},
                   element("td", {}, link(anchor_of_study(study.name), study.name)) +
                       number_cell(count.passed, "pass") + number_cell(count.failed, "fail") +
                       number_cell(count.not_gated, "open") +
                       element("td", {{"class", "count"}}, duration(study.seconds)) +
                       element("td", {}, fmt::format("{}", fmt::join(study.grids, ", ")))) +
           "\n";
}

}  // namespace

std::string anchor_of_study(const std::string& name) {
    return anchor("study-", name);
}

std::vector<GateResult> gates_of(const Verification& v, const std::string& study) {
    std::vector<GateResult> gates;
    for (const auto& gate : v.gates)
        if (gate.study == study) gates.push_back(gate);
    return gates;
}

Html headline(const Verification& v) {
    return element(
               "header", {},
               element("h1", {},
                       "Crawford: verification " +
                           element("span", {{"class", "mark " + style(v)}}, verdict(v))) +
                   element("p", {{"class", "count-of-all"}},
                           text(count(v.gates)) + fmt::format(", {} studies", v.studies.size())) +
                   circumstances(v) + shortcomings(v)) +
           "\n";
}

Html table_of_studies(const Verification& v) {
    Html rows = row("th", {"study", "pass", "fail", "not gated", "CPU", "grids"});
    for (const auto& study : v.studies) rows += study_row(v, study);
    return element("section", {{"id", "studies"}},
                   element("h2", {}, "Studies") + element("table", {{"class", "studies"}}, rows)) +
           "\n";
}

}  // namespace crawford::reports::page
