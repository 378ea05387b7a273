#include "reports/page/study_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/page/gate_card.hpp"
#include "reports/page/overview.hpp"
#include "reports/page/prose.hpp"

namespace crawford::reports::page {
namespace {

/// Where the gates of a study stand among all, those that fell short first.
std::vector<std::size_t> indices_of(const Verification& v, const std::string& study) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < v.gates.size(); ++i)
        if (v.gates[i].study == study) indices.push_back(i);
    std::stable_partition(indices.begin(), indices.end(),
                          [&](std::size_t i) { return v.gates[i].fell_short(); });
    return indices;
}

Html study_section(const Verification& v, const StudyRecord& study) {
    Html cards;
    for (const auto i : indices_of(v, study.name)) cards += gate_card(v.gates[i], i);
    Html text = element("h3", {}, study.name);
    text += element("p", {{"class", "facts"}}, element("code", {}, study.command));
    if (!study.covers.empty())
        text += element("p", {{"class", "facts"}},
                        "covers " + fmt::format("{}", fmt::join(study.covers, "; ")));
    text += element("div", {{"class", "gates"}}, cards);
    return element("section", {{"id", anchor_of_study(study.name)}, {"class", "study"}}, text) +
           "\n";
}

bool fell_short(const Verification& v, const std::string& entry) {
    return std::ranges::any_of(gates_of(v, entry), &GateResult::fell_short);
}

Html entry_section(const Verification& v, const std::string& entry) {
    Html text;
    for (const auto& study : v.studies) {
        if (study.entry != entry) continue;
        if (text.empty())
            text += prose(study.page.empty() ? "# " + entry : study.page) +
                    element("p", {{"class", "facts"}}, element("code", {}, study.source));
        text += study_section(v, study);
    }
    return element("section", {{"id", anchor_of_entry(entry)}, {"class", "entry"}}, text) + "\n";
}

}  // namespace

Html study_sections(const Verification& v) {
    Html html;
    auto entries = entries_of(v);
    std::stable_partition(entries.begin(), entries.end(),
                          [&](const auto& entry) { return fell_short(v, entry); });
    for (const auto& entry : entries) html += entry_section(v, entry);
    return html;
}

}  // namespace crawford::reports::page
