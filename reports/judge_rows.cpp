#include "reports/judge_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/default_estimate.hpp"

namespace crawford::reports {
namespace {

class Judge {
public:
    Judge(const Study& study, const std::vector<GridRun>& runs) : runs_(runs) {
        for (const auto& run : runs_) wanted_.push_back(run.grid);
        for (const int grid : study.grids())
            if (std::ranges::find(wanted_, grid) == wanted_.end()) left_out_.push_back(grid);
        std::ranges::sort(left_out_);
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
                     wanted_, left_out_of(gate.expected));
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
        const auto left_out = left_out_of(row.gate.expected);
        const double size = gate.expected.scale.value_or(scale);
        // Grids left out in between leave pairs of unequal ratio, of which no order can be read.
        const auto convergence = left_out.empty() ? from_differences(std::move(levels), size)
                                                  : Convergence(std::move(levels), size);
        const std::vector<int> coarser(wanted_.begin(), wanted_.end() - 1);
        return judge(gate, convergence, coarser, left_out);
    }

    GateResult operator()(const Study::GridBound& row) const {
        const Bound bound = titled(row);
        if (std::ranges::find(left_out_, row.grid) != left_out_.end())
            return ungated(bound, row.bound.quantity, {row.grid});
        const auto run = std::ranges::find(runs_, row.grid, &GridRun::grid);
        if (run == runs_.end())
            return unjudged(bound, fmt::format("grid {} was not run", row.grid));
        const auto value = value_of(*run, row.bound.quantity);
        if (!value) return unjudged(bound, fmt::format("no value from grid {}", row.grid));
        auto result = judge(bound, *value);
        record(result, row.bound.quantity);
        return result;
    }

    GateResult operator()(const Study::LimitBound& row) const {
        const Bound bound = titled(row);
        if (!left_out_.empty()) return ungated(bound, row.bound.quantity, left_out_);
        for (const auto& run : runs_)
            if (!value_of(run, row.bound.quantity))
                return unjudged(bound, fmt::format("no value from grid {}", run.grid));
        GateResult seen;
        record(seen, row.bound.quantity);
        const auto limit = default_limit(seen.h, seen.values, row.formal_order);
        auto result = judge(bound, limit.value);
        record(result, row.bound.quantity);
        result.limit = limit;
        return result;
    }

    GateResult operator()(const Study::TotalBound& row) const {
        const Bound bound = titled(row);
        if (!left_out_.empty()) return ungated(bound, row.bound.quantity, left_out_);
        double sum = 0.0;
        for (const auto& run : runs_) {
            const auto value = value_of(run, row.bound.quantity);
            if (!value) return unjudged(bound, fmt::format("no value from run {}", run.grid));
            sum += *value;
        }
        return judge(bound, sum);
    }

    /// The bound as it is listed: with the grid that it is of.
    static Bound titled(const Study::GridBound& row) {
        Bound bound = row.bound;
        bound.quantity += fmt::format(", grid {}", row.grid);
        return bound;
    }
    static Bound titled(const Study::LimitBound& row) {
        Bound bound = row.bound;
        bound.quantity += ", h -> 0";
        return bound;
    }
    static Bound titled(const Study::TotalBound& row) {
        Bound bound = row.bound;
        bound.quantity += ", all runs";
        return bound;
    }

    /// A row that was not judged at all keeps its name and reason.
    static GateResult unjudged(const Bound& bound, const std::string& why) {
        auto result = judge(bound, not_applicable);
        result.failure = why;
        return result;
    }

private:
    static std::optional<double> value_of(const GridRun& run, const std::string& quantity) {
        return run.measurement ? run.measurement->value_of(quantity) : std::nullopt;
    }

    std::optional<Sample> sample(std::size_t i, const std::string& quantity) const {
        return runs_[i].measurement ? runs_[i].measurement->sample_of(quantity) : std::nullopt;
    }

    std::vector<int> left_out_of(const Expectation& range) const {
        auto grids = left_out_;
        std::erase_if(grids, [&](int grid) {
            return grid < range.coarsest.value_or(grid) || grid > range.finest.value_or(grid);
        });
        return grids;
    }

    /// The values of a quantity on all grids that have one.
    void record(GateResult& result, const std::string& quantity) const {
        for (const auto& run : runs_) {
            const auto value = value_of(run, quantity);
            if (!value) continue;
            result.grids.push_back(run.grid);
            result.h.push_back(run.measurement->h());
            result.values.push_back(*value);
        }
    }

    /// Not gated, unless a run failed or found a value that is no number.
    GateResult ungated(const Bound& bound, const std::string& quantity,
                       const std::vector<int>& left_out) const {
        auto result = unjudged(bound, "");
        record(result, quantity);
        if (!std::ranges::all_of(runs_,
                                 [](const GridRun& run) { return run.measurement.has_value(); }))
            result.failure = "a run has failed";
        else if (!std::ranges::all_of(result.values, [](double v) { return std::isfinite(v); }))
            result.failure = fmt::format("a value of {} is no number", quantity);
        else
            leave_ungated(result, left_out);
        return result;
    }

    const std::vector<GridRun>& runs_;
    std::vector<int> wanted_, left_out_;
};

/// What a row says about itself.
GateResult described(const Study::Row& row) {
    const auto describe = [](const auto& r) {
        if constexpr (requires { r.gate; }) {
            return judge(r.gate, Convergence({}), {});
        } else {
            return Judge::unjudged(Judge::titled(r), "");
        }
    };
    return std::visit(describe, row);
}

GateResult judged(const Judge& judge, const Study::Row& row) {
    try {
        return std::visit(judge, row);
    } catch (const std::invalid_argument& problem) {
        auto result = described(row);
        result.failure = problem.what();
        return result;
    }
}

}  // namespace

GridRun grid_run(const Study& study, const Record& record) {
    return {record.setting.count(study.axis()), record.found, record.ending.message,
            record.cost.cpu_seconds};
}

std::vector<GateResult> judge_rows(const Study& study, const std::vector<GridRun>& runs) {
    double seconds = 0.0;
    std::string causes;
    for (const auto& run : runs) {
        seconds += run.seconds;
        if (!run.failure.empty()) causes += fmt::format("; grid {}: {}", run.grid, run.failure);
    }

    std::vector<GateResult> results;
    for (const auto& row : study.rows()) {
        GateResult result;
        if (runs.empty()) {
            result = described(row);
            leave_ungated(result, study.grids());
        } else {
            result = judged(Judge(study, runs), row);
        }
        result.study = study.name();
        result.seconds = seconds;
        if (result.fell_short()) result.failure += causes;
        results.push_back(std::move(result));
    }
    return results;
}

}  // namespace crawford::reports
