#include "reports/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/wrapped.hpp"

namespace crawford::reports {
namespace {

constexpr std::size_t width = 100;
constexpr std::size_t grids_per_line = 8;

std::string wrapped(const std::string& text, const std::string& indent) {
    return reports::wrapped(text, indent, width);
}

std::string row(const std::string& label, const std::vector<std::string>& cells) {
    std::string line = fmt::format("    {:<8}", label);
    for (const auto& cell : cells) line += fmt::format(" {:>9}", cell);
    return line + '\n';
}

template <typename T>
std::vector<std::string> cells(const std::vector<T>& values, std::size_t from, std::size_t to,
                               const char* form) {
    std::vector<std::string> texts;
    for (std::size_t i = from; i < std::min(to, values.size()); ++i)
        texts.push_back(fmt::format(fmt::runtime(form), values[i]));
    return texts;
}

/// Grids, sizes, errors, and under each error the order that led to it.
std::string numbers(const GateResult& r) {
    std::string text;
    for (std::size_t from = 0; from < r.grids.size(); from += grids_per_line) {
        const std::size_t to = from + grids_per_line;
        text += row("grid", cells(r.grids, from, to, "{}"));
        text += row("h", cells(r.h, from, to, "{:.3e}"));
        text += r.values.empty() ? row("error", cells(r.errors, from, to, "{:.3e}"))
                                 : row("value", cells(r.values, from, to, "{:.3e}"));
        if (r.pairwise.empty()) continue;
        const std::size_t blank = r.grids.size() - r.pairwise.size();
        auto orders = cells(r.pairwise, from == 0 ? 0 : from - blank, to - blank, "{:.3f}");
        if (from == 0) orders.insert(orders.begin(), blank, "");
        text += row("order", orders);
    }
    return text;
}

std::string headline(const std::string& what, const GateResult& r) {
    const std::string how = mark(r) == Mark::not_gated ? "----" : word(mark(r));
    const std::size_t room = width - how.size() - 1;
    if (what.size() > room) return wrapped(what + ' ' + how, "  ");
    return fmt::format("{:<{}} {}\n", what, room, how);
}

std::string tolerance(double below, double above) {
    if (below == above) return fmt::format("+- {:.3g}", below);
    return std::isinf(above) ? fmt::format("- {:.3g}, or better", below)
                             : fmt::format("- {:.3g} + {:.3g}", below, above);
}

std::string of_order(const GateResult& r) {
    auto text =
        headline(fmt::format("  {}, {}: order {:.3g} {}, grids {} to {}", r.quantity, r.norm,
                             r.expected, tolerance(r.below, r.above), r.coarsest, r.finest),
                 r);
    text += numbers(r);
    text += fmt::format("    fit {:.3f}, {}", r.fit, r.verdict);
    if (!std::isnan(r.limit.value))
        text += fmt::format("; error at h -> 0: {:.2e}, grid uncertainty {:.2e} (x {})",
                            r.limit.value, r.limit.uncertainty, r.limit.safety);
    return text + '\n';
}

std::string of_bound(const GateResult& r) {
    const auto value = r.gated ? fmt::format(" = {:.6g}", r.value) : "";
    auto text = headline(
        fmt::format("  {}{}, allowed {:.6g} to {:.6g}", r.quantity, value, r.low, r.high), r);
    if (!r.grids.empty()) text += numbers(r);
    if (!std::isnan(r.limit.value))
        text += fmt::format("    at h -> 0: {:.8g}, grid uncertainty {:.2e} (x {}), order {:.3f}\n",
                            r.limit.value, r.limit.uncertainty, r.limit.safety, r.limit.observed);
    return text;
}

}  // namespace

std::string table(const std::vector<GateResult>& results) {
    std::string text, study;
    for (const auto& result : results) {
        if (result.study != study || text.empty()) text += wrapped(result.study, "");
        study = result.study;
        text += result.kind == GateKind::order ? of_order(result) : of_bound(result);
        text += wrapped(fmt::format("because {} ({:.1f} CPU s)", result.reason, result.seconds),
                        "    ");
        if (!result.passed)
            text += wrapped((result.gated ? "FAIL: " : "") + result.failure, "    ");
    }
    return text;
}

Count count(const std::vector<GateResult>& results) {
    Count count;
    for (const auto& result : results)
        ++(result.passed ? count.passed : result.gated ? count.failed : count.not_gated);
    return count;
}

Mark mark(const GateResult& result) {
    if (result.passed) return Mark::pass;
    return result.gated ? Mark::fail : Mark::not_gated;
}

Mark mark(const Count& count) {
    if (count.failed > 0) return Mark::fail;
    return count.not_gated > 0 ? Mark::not_gated : Mark::pass;
}

const char* word(Mark mark) {
    switch (mark) {
        case Mark::pass:
            return "pass";
        case Mark::fail:
            return "FAIL";
        case Mark::not_gated:
            break;
    }
    return "not gated";
}

std::string text(const Count& count) {
    if (count.all() == 0) return "no gates: nothing is shown";
    if (count.not_gated == 0 && count.failed == 0)
        return fmt::format("{} of {} gates pass", count.passed, count.all());
    auto line = fmt::format("{} pass, {} fail", count.passed, count.failed);
    if (count.not_gated > 0) line += fmt::format(", {} not gated: too few grids", count.not_gated);
    return line;
}

bool all_passed(const std::vector<GateResult>& results) {
    return !results.empty() && std::ranges::all_of(results, &GateResult::passed);
}

}  // namespace crawford::reports
