#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "reports/grid_runs.hpp"
#include "reports/study.hpp"

namespace crawford::reports {
namespace {

/// Judges each kind of row on the runs of one study.
class Judge {
public:
    explicit Judge(const std::vector<GridRun>& runs) : runs_(runs) {
        for (const auto& run : runs_) wanted_.push_back(run.grid);
    }

    GateResult operator()(const Study::ErrorGate& row) const {
        const auto& gate = row.gate;
        std::vector<Level> levels;
        double scale = 0.0;
        for (const auto& run : runs_) {
            if (!run.measurement) continue;
            const auto found = run.measurement->error_of(gate.quantity, gate.norm);
            if (!found) continue;
            levels.push_back({run.grid, run.measurement->h(), found->error});
            scale = found->scale;  // the finest grid knows the truth's size best
        }
        return judge(gate, Convergence(std::move(levels), gate.expected.scale.value_or(scale)),
                     wanted_);
    }

    /// A difference stands for the coarser of its two grids, so the range of the fit ends one grid
    /// earlier.
    GateResult operator()(const Study::DifferenceGate& row) const {
        auto gate = row.gate;
        std::vector<Level> levels;
        double scale = 0.0;
        for (std::size_t i = 0; i + 1 < runs_.size(); ++i) {
            if (gate.expected.finest == runs_[i + 1].grid) gate.expected.finest = runs_[i].grid;
            const auto coarse = sample(i, gate.quantity), fine = sample(i + 1, gate.quantity);
            if (!coarse || !fine) continue;
            levels.push_back({runs_[i].grid, runs_[i].measurement->h(),
                              distance(gate.norm, coarse->values, fine->values, coarse->weights)});
            scale = norm(gate.norm, fine->values, coarse->weights);
        }
        const std::vector<int> coarser(wanted_.begin(), wanted_.end() - 1);
        return judge(gate, from_differences(std::move(levels), gate.expected.scale.value_or(scale)),
                     coarser);
    }

    GateResult operator()(const Study::GridBound& row) const {
        const auto run = std::ranges::find(runs_, row.grid, &GridRun::grid);
        auto bound = row.bound;
        bound.quantity += fmt::format(", grid {}", row.grid);
        if (run == runs_.end())
            return unjudged(bound, fmt::format("grid {} was not run", row.grid));
        const auto value =
            run->measurement ? run->measurement->value_of(row.bound.quantity) : std::nullopt;
        if (!value) return unjudged(bound, fmt::format("no value from grid {}", row.grid));
        return judge(bound, *value);
    }

    GateResult operator()(const Study::LimitBound& row) const {
        auto bound = row.bound;
        bound.quantity += ", h -> 0";
        std::vector<double> h, values;
        for (const auto& run : runs_) {
            const auto value =
                run.measurement ? run.measurement->value_of(row.bound.quantity) : std::nullopt;
            if (!value) return unjudged(bound, fmt::format("no value from grid {}", run.grid));
            h.push_back(run.measurement->h());
            values.push_back(*value);
        }
        const auto limit = extrapolate(h, values, row.formal_order);
        auto result = judge(bound, limit.value);
        result.limit = limit;
        return result;
    }

    static GateResult unjudged(const Bound& bound, const std::string& why) {
        auto result = judge(bound, not_applicable);
        result.failure = why;
        return result;
    }

private:
    std::optional<Sample> sample(std::size_t i, const std::string& quantity) const {
        return runs_[i].measurement ? runs_[i].measurement->sample_of(quantity) : std::nullopt;
    }

    const std::vector<GridRun>& runs_;
    std::vector<int> wanted_;
};

/// A row that could not be judged at all keeps its name and reason.
GateResult broken(const Study::Row& row, const std::string& why) {
    const auto describe = [](const auto& r) {
        GateResult result;
        if constexpr (requires { r.gate; }) {
            result.quantity = r.gate.quantity;
            result.norm = name(r.gate.norm);
            result.reason = r.gate.reason;
            result.expected = r.gate.expected.order;
            result.verdict = "none";
        } else {
            result = Judge::unjudged(r.bound, "");
        }
        return result;
    };
    auto result = std::visit(describe, row);
    result.failure = why;
    return result;
}

GateResult judged(const Judge& judge, const Study::Row& row) {
    try {
        return std::visit(judge, row);
    } catch (const std::invalid_argument& problem) {
        return broken(row, problem.what());
    }
}

}  // namespace

std::vector<GateResult> run(const Study& study, std::vector<int> grids,
                            const OnProgress& on_progress) {
    if (!study.measure()) throw std::invalid_argument(study.name() + ": nothing to measure");
    if (study.rows().empty()) throw std::invalid_argument(study.name() + ": no gate");
    if (grids.empty()) grids = study.grids();
    if (grids.empty()) throw std::invalid_argument(study.name() + ": no grid");

    const auto runs = run_grids(study, std::move(grids), on_progress);
    double seconds = 0.0;
    std::string causes;
    for (const auto& run : runs) {
        seconds += run.seconds;
        if (!run.failure.empty()) causes += fmt::format("; grid {}: {}", run.grid, run.failure);
    }

    std::vector<GateResult> results;
    for (const auto& row : study.rows()) {
        auto result = judged(Judge(runs), row);
        result.study = study.name();
        result.seconds = seconds;
        if (!result.passed) result.failure += causes;
        results.push_back(std::move(result));
    }
    return results;
}

}  // namespace crawford::reports
