/// Studies: the same run on several grids, and the gates that the outcome is held against.
///
///     Study("slab, AP")
///         .refines("rows", {32, 64, 128, 256})
///         .measure([](int rows) { ... return Measurement(h).field("temperature", T, exact); })
///         .gate("temperature", Norm::L2, expect(2.0).within(0.1), "central differences, steady")
///         .bound("T_s - exact [K]", 128, between(-1.0, 1.0), "a quarter of the model difference");
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reports/gate.hpp"
#include "reports/record.hpp"
#include "reports/record_store.hpp"

namespace crawford::reports {

/// What to run at one setting. Settings run at the same time in several threads: share nothing that
/// changes.
using Measure = std::function<Measurement(const Setting&)>;
/// The same for a run that depends on nothing but the value of the axis that is refined.
using MeasureGrid = std::function<Measurement(int value)>;
/// The same for a run that leaves more than numbers, as what the solver said: fills the record.
using FillRecord = std::function<void(Record&)>;

class Study {
public:
    struct ErrorGate {
        Gate gate;
    };
    struct DifferenceGate {
        Gate gate;
    };
    struct GridBound {
        Bound bound;
        int grid;
    };
    struct LimitBound {
        Bound bound;
        double formal_order;
    };
    struct TotalBound {
        Bound bound;
    };
    using Row = std::variant<ErrorGate, DifferenceGate, GridBound, LimitBound, TotalBound>;

    explicit Study(std::string name) : name_(std::move(name)) {}

    /// The axis that is refined, and its values: cells, columns, rows, steps. The judgement calls a
    /// value of it a grid.
    Study& refines(std::string axis, std::vector<int> values);
    /// Settings side by side, 1 to `count`, where nothing is refined: each is a run, a record and
    /// costs alike. Their values are gated by total().
    Study& lists(std::string axis, int count);
    /// Nothing else of a run, as its steps or layers, hangs on the axis: it takes any value, where
    /// others take what divides their own.
    Study& any_value();
    /// Another axis, which is the same in all runs.
    Study& at(const std::string& axis, AxisValue value);
    Study& measure(Measure measure);
    /// Call it after refines().
    Study& measure(MeasureGrid measure);
    Study& run(FillRecord run);
    /// The terms of the equations in which this study would see a fault: its columns of the
    /// coverage matrix.
    Study& covers(std::vector<std::string> terms);

    /// The error of `quantity` must fall at the expected order.
    Study& gate(std::string quantity, Norm norm, Expectation expected, std::string reason);
    /// The same, from successive differences of a sample or value: for studies without a truth.
    Study& difference_gate(std::string quantity, Norm norm, Expectation expected,
                           std::string reason);
    /// The value of `quantity` on `grid` must lie in the interval; a grid that is none of the
    /// study's is a failure.
    Study& bound(std::string quantity, int grid, Interval allowed, std::string reason);
    /// The value extrapolated to h -> 0 from the three finest grids at the formal order must lie in
    /// the interval.
    Study& limit_bound(std::string quantity, double formal_order, Interval allowed,
                       std::string reason);
    /// The sum of `quantity` over all runs must lie in the interval; a run that failed is a failure.
    Study& total(std::string quantity, Interval allowed, std::string reason);

    const std::string& name() const { return name_; }
    const std::string& axis() const { return axis_; }
    const std::vector<int>& grids() const { return grids_; }
    bool takes_any_value() const { return takes_any_value_; }
    /// Whether it lists settings and refines nothing.
    bool is_a_list() const { return is_a_list_; }
    /// What a run on this grid is set to.
    Setting setting(int grid) const;
    const std::vector<std::string>& covered() const { return covered_; }
    const std::vector<Row>& rows() const { return rows_; }
    const FillRecord& run() const { return run_; }

private:
    std::string name_;
    std::string axis_;
    Setting fixed_;
    std::vector<int> grids_;
    bool takes_any_value_ = false;
    bool is_a_list_ = false;
    std::vector<std::string> covered_;
    FillRecord run_;
    std::vector<Row> rows_;
};

/// One run done.
struct Progress {
    std::string study;
    Setting setting;
    double seconds;
    std::size_t done, total;
    std::string failure;  ///< empty unless the run threw
    double to_go;         ///< seconds that the rest will take, from the pace so far and the costs
};
using OnProgress = std::function<void(const Progress&)>;

/// A study to be run.
struct Task {
    Study study;
    /// None: all of the study's own. Gates that need another of the study's own are then left
    /// ungated.
    std::optional<std::vector<int>> grids = {};
    double seconds = 1.0;  ///< what all of the study's own grids are expected to take
};

/// What has become of a task.
struct StudyResult {
    std::vector<int> grids;         ///< those that were run
    std::vector<GateResult> gates;  ///< one for each row, in the order written
    double seconds;                 ///< wall time of its runs, summed
    std::size_t kept = 0;           ///< how many of its runs were taken from the store
    bool is_foreign = false;        ///< whether a record is of another fingerprint than the store
};

/// Runs all grids of all tasks out of one queue (base/job_queue.hpp), `threads` at a time, and
/// judges every row. What `store` holds is not run again, and what is run is added to it at once. A run that throws fails
/// every gate that needs it, with the reason; it stops nothing else. `on_progress` is called from
/// one thread at a time.
/// \throws std::invalid_argument if a study has nothing to measure, no grid or no gate.
std::vector<StudyResult> run(const std::vector<Task>& tasks, RecordStore* store = nullptr,
                             const OnProgress& on_progress = {},
                             std::optional<unsigned> threads = {});

/// Judges what `store` holds, whatever its fingerprint, and runs nothing: a grid without a record
/// is one that was left out.
/// \throws std::invalid_argument likewise.
std::vector<StudyResult> judge_kept(const std::vector<Task>& tasks, RecordStore& store);

/// Runs one study, on its own grids or on `grids` if any are given.
std::vector<GateResult> run(const Study& study, std::vector<int> grids = {},
                            const OnProgress& on_progress = {});

}  // namespace crawford::reports
