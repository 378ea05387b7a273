#include "report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace crawford::mutants {

namespace {

using Row = std::vector<std::string>;

/// What would end a cell must not.
std::string escaped(const std::string& cell) {
    std::string text;
    for (const char c : cell) text += c == '|' ? "\\|" : std::string(1, c);
    return text;
}

/// The first row is the heading. Columns are as wide as their widest cell.
std::string markdown(std::vector<Row> rows) {
    for (Row& row : rows) std::ranges::transform(row, row.begin(), escaped);
    std::vector<size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows)
        for (size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    Row rule;
    for (const size_t width : widths) rule.emplace_back(width, '-');
    rows.insert(rows.begin() + 1, rule);

    std::string text;
    for (const Row& row : rows) {
        for (size_t k = 0; k < row.size(); ++k) text += fmt::format("| {:<{}} ", row[k], widths[k]);
        text += "|\n";
    }
    return text;
}

std::string gates(const Finding& finding, bool every_gate) {
    if (every_gate) return fmt::format("{}", fmt::join(finding.gates, "; "));
    const size_t more = finding.gates.size() - 1;
    return finding.gates.front() + (more == 0 ? "" : fmt::format(" (and {} more)", more));
}

std::string fate(const Verdict& verdict, bool every_gate) {
    if (!verdict.broken.empty()) return "WORTHLESS ROW";
    if (!verdict.killer()) return "SURVIVED";
    return gates(verdict.killer()->finding, every_gate);
}

std::string list(const std::string& heading, const std::vector<std::string>& items) {
    if (items.empty()) return "";
    return fmt::format("\n{}\n\n- {}\n", heading, fmt::join(items, "\n- "));
}

/// Labels of all judges that saw a fault.
std::vector<std::string> witnesses(const Verdict& verdict) {
    std::vector<std::string> labels;
    for (const auto& [judge, finding] : verdict.heard)
        if (finding.killed()) labels.push_back(judge.label());
    return labels;
}

}  // namespace

std::string table_of_faults(const std::vector<Verdict>& verdicts, bool every_gate) {
    std::vector<Row> rows{{"fault", "file", "breaks", "seen by", "s"}};
    std::vector<std::string> survivors;
    std::vector<std::string> unexpected;
    std::vector<std::string> worthless;
    for (const Verdict& v : verdicts) {
        rows.push_back({v.fault.name, v.fault.file, v.fault.breaks, fate(v, every_gate),
                        fmt::format("{:.1f}", v.seconds())});
        if (v.survived()) survivors.push_back(v.fault.name + ": " + v.fault.breaks);
        if (v.killer() && !(v.killer()->judge == v.fault.seen_by))
            unexpected.push_back(fmt::format("{}: {}, not {}", v.fault.name,
                                             v.killer()->judge.label(), v.fault.seen_by.label()));
        if (!v.broken.empty()) worthless.push_back(v.broken);
    }
    const size_t seen = verdicts.size() - survivors.size() - worthless.size();
    return markdown(std::move(rows)) +
           fmt::format("\n{} of {} faults seen\n", seen, verdicts.size()) +
           list("Survivors:", survivors) + list("Seen by another than expected:", unexpected) +
           list("Worthless rows:", worthless);
}

std::string table_of_judges(const std::vector<Verdict>& verdicts) {
    struct Seen {
        size_t faults = 0;
        std::vector<std::string> alone;
    };
    std::map<std::string, Seen> judges;
    for (const Verdict& v : verdicts) {
        for (const auto& sighting : v.heard) judges[sighting.judge.label()];
        const auto labels = witnesses(v);
        for (const std::string& label : labels) ++judges[label].faults;
        if (labels.size() == 1) judges[labels.front()].alone.push_back(v.fault.name);
    }
    std::vector<Row> rows{{"judge", "sees", "alone sees"}};
    for (const auto& [label, seen] : judges)
        rows.push_back(
            {label, std::to_string(seen.faults),
             seen.alone.empty() ? "NOTHING" : fmt::format("{}", fmt::join(seen.alone, ", "))});

    std::vector<Row> matrix{{"fault", "seen by"}};
    for (const Verdict& v : verdicts)
        matrix.push_back({v.fault.name, fmt::format("{}", fmt::join(witnesses(v), ", "))});
    return markdown(std::move(rows)) + '\n' + markdown(std::move(matrix));
}

}  // namespace crawford::mutants
