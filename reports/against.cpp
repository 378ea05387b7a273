#include "reports/against.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "reports/wrapped.hpp"

namespace crawford::reports {
namespace {

constexpr std::size_t width = 80;

/// A gate among those of a run: the last member tells apart those that share all else.
using Key = std::tuple<std::string, GateKind, std::string, std::string, int>;
using Index = std::map<Key, const GateResult*>;

Index index_of(const std::vector<GateResult>& gates) {
    Index index;
    for (const GateResult& gate : gates) {
        Key key{gate.study, gate.kind, gate.quantity, gate.norm, 0};
        while (index.contains(key)) ++std::get<int>(key);
        index.emplace(std::move(key), &gate);
    }
    return index;
}

std::string title(const GateResult& gate) {
    return fmt::format("{}/{}{}{}", gate.study, gate.quantity, gate.norm.empty() ? "" : ", ",
                       gate.norm);
}

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b, [](double x, double y) { return same(x, y); });
}

/// What is not the same, in the words of verify.json; empty if nothing.
std::string differing(const GateResult& a, const GateResult& b) {
    std::string names;
    const auto note = [&](bool is_same, const char* name) {
        if (!is_same) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    note(a.grids == b.grids, "grids");
    note(same(a.h, b.h), "h");
    note(same(a.errors, b.errors), "errors");
    note(same(a.values, b.values), "values");
    note(same(a.value, b.value), "value");
    note(same(a.pairwise, b.pairwise), "pairwise_orders");
    note(same(a.fit, b.fit), "fit");
    note(same(a.scale, b.scale), "scale");
    note(a.verdict == b.verdict, "verdict");
    note(a.passed == b.passed && a.gated == b.gated, "passed");
    return names;
}

/// The errors on the finest grid that both runs have.
struct FinestErrors {
    double before, now;
    bool before_is_roundoff;

    double growth() const { return now / before; }
};

std::optional<FinestErrors> finest_errors(const GateResult& before, const GateResult& now) {
    for (std::size_t i = std::min(before.grids.size(), before.errors.size()); i-- > 0;) {
        const auto at = std::ranges::find(now.grids, before.grids[i]);
        const auto j = static_cast<std::size_t>(at - now.grids.begin());
        if (j >= now.errors.size()) continue;
        const double error = before.errors[i];
        const bool is_roundoff = error == 0.0 || error < roundoff * before.scale;
        return FinestErrors{error, now.errors[j], is_roundoff};
    }
    return {};
}

class Comparing {
public:
    Comparing(const Scope& scope, const Yardstick& yardstick) : scope_(scope) {
        found_.yardstick = yardstick;
    }

    void only_before(const GateResult& gate) {
        if (scope_.own_grids && was_run(gate.study))
            list(Change::gone, gate, "");
        else
            ++found_.left_out;
    }

    void only_now(const GateResult& gate) { list(Change::added, gate, ""); }

    void both(const GateResult& before, const GateResult& now) {
        const bool exact = found_.yardstick.exact;
        if (is_left_out(before, now)) {
            ++found_.left_out;
            return;
        }
        ++found_.compared;
        const auto listed = found_.changed.size();
        if (before.passed && !now.passed)
            list(Change::lost, now, now.failure);
        else if (before.passed != now.passed || before.verdict != now.verdict)
            list(Change::other, now, fmt::format("{}, was {}", now.verdict, before.verdict));
        if (const auto errors = finest_errors(before, now)) compare_errors(now, *errors);
        if (!exact || found_.changed.size() > listed) return;
        if (const auto names = differing(before, now); !names.empty())
            list(Change::other, now, names);
    }

    Comparison found() && { return std::move(found_); }

private:
    bool was_run(const std::string& study) const {
        return scope_.every_study ||
               std::ranges::find(scope_.studies, study) != scope_.studies.end();
    }

    /// A gate that misses grids because nobody chose them says nothing; one that misses them
    /// although all were to be there has been lost.
    bool is_left_out(const GateResult& before, const GateResult& now) const {
        if (before.gated == now.gated) return !now.gated && !found_.yardstick.exact;
        return !scope_.own_grids || (!before.gated && !found_.yardstick.exact);
    }

    void list(Change change, const GateResult& gate, std::string detail) {
        found_.changed.push_back({change, title(gate), std::move(detail)});
    }

    void compare_errors(const GateResult& gate, const FinestErrors& errors) {
        const double factor = found_.yardstick.grown;
        if (std::isnan(errors.now) && std::isnan(errors.before)) return;
        if (std::isnan(errors.now)) {
            list(Change::grown, gate, fmt::format("no number, was {:.6e}", errors.before));
            return;
        }
        if (errors.before_is_roundoff) {
            if (!(errors.now <= factor * errors.before))
                list(Change::from_roundoff, gate,
                     fmt::format("{:.3e}, was {:.3e}", errors.now, errors.before));
            return;
        }
        const double growth = errors.growth();
        found_.largest_growth = std::fmax(found_.largest_growth, growth);
        const auto detail =
            fmt::format("{:.6e}, was {:.6e}: x {:.4g}", errors.now, errors.before, growth);
        if (growth > factor)
            list(Change::grown, gate, detail);
        else if (growth * factor < 1.0)
            list(Change::shrunk, gate, detail);
        else if (std::isnan(growth))  // a number where there was none
            list(Change::other, gate, detail);
    }

    const Scope& scope_;
    Comparison found_;
};

std::string lines_of(const ChangedGate& one) {
    auto lines = wrapped(fmt::format("{}: {}", name(one.change), one.gate), "", width);
    return lines + wrapped(one.detail, "    ", width);
}

}  // namespace

std::string_view name(Change change) {
    switch (change) {
        case Change::gone:
            return "gone";
        case Change::added:
            return "new";
        case Change::lost:
            return "lost";
        case Change::grown:
            return "grown";
        case Change::shrunk:
            return "shrunk";
        case Change::from_roundoff:
            return "round-off";
        case Change::other:
            break;
    }
    return "other";
}

std::size_t Comparison::count(Change change) const {
    return static_cast<std::size_t>(std::ranges::count(changed, change, &ChangedGate::change));
}

bool Comparison::fell_short() const {
    return yardstick.exact ? !changed.empty() : count(Change::grown) > 0;
}

Comparison compare(const std::vector<GateResult>& before, const std::vector<GateResult>& now,
                   const Scope& scope, const Yardstick& yardstick) {
    Comparing comparing(scope, yardstick);
    const Index old = index_of(before), found = index_of(now);
    for (const auto& [key, gate] : old)
        if (!found.contains(key)) comparing.only_before(*gate);
    for (const auto& [key, gate] : found) {
        const auto at = old.find(key);
        if (at == old.end())
            comparing.only_now(*gate);
        else
            comparing.both(*at->second, *gate);
    }
    return std::move(comparing).found();
}

std::string text(const Comparison& c) {
    std::string lines;
    for (const ChangedGate& one : c.changed) lines += lines_of(one);
    auto last =
        fmt::format("{} gates compared{}", c.compared, c.yardstick.exact ? " bit by bit" : "");
    if (c.left_out > 0) last += fmt::format(", {} not run or not gated and left out", c.left_out);
    for (const Change change : {Change::gone, Change::added, Change::lost, Change::grown,
                                Change::shrunk, Change::from_roundoff, Change::other})
        if (c.count(change) > 0) last += fmt::format(", {} {}", c.count(change), name(change));
    if (c.changed.empty()) last += c.yardstick.exact ? ": all the same" : ": nothing to list";
    if (c.largest_growth > 0.0)
        last += fmt::format("; the largest growth of a finest error is x {:.4g}", c.largest_growth);
    return lines + wrapped(last, "", width);
}

}  // namespace crawford::reports
