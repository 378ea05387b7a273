#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reports/gate.hpp"
#include "reports/measurement.hpp"

/// Studies: the same run on several grids, and the gates that the outcome is held against.
///
///     Study("slab, AP")
///         .grids({32, 64, 128, 256})
///         .measure([](int cells) { ... return Measurement(h).field("temperature", T, exact); })
///         .gate("temperature", Norm::L2, expect(2.0).within(0.1), "central differences, steady")
///         .bound("T_s - exact [K]", 128, between(-1.0, 1.0), "a quarter of the model difference");
namespace crawford::reports {

/// What to run on one grid. Grids run at the same time in several threads: share nothing that
/// changes.
using Measure = std::function<Measurement(int grid)>;

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
    using Row = std::variant<ErrorGate, DifferenceGate, GridBound, LimitBound>;

    explicit Study(std::string name) : name_(std::move(name)) {}

    Study& grids(std::vector<int> cells);
    Study& measure(Measure measure);
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

    const std::string& name() const { return name_; }
    const std::vector<int>& grids() const { return grids_; }
    const std::vector<std::string>& covered() const { return covered_; }
    const std::vector<Row>& rows() const { return rows_; }
    const Measure& measure() const { return measure_; }

private:
    std::string name_;
    std::vector<int> grids_;
    std::vector<std::string> covered_;
    Measure measure_;
    std::vector<Row> rows_;
};

/// One grid done.
struct Progress {
    std::string study;
    int grid;
    double seconds;
    std::size_t done, total;
    std::string failure;  ///< Empty unless the run of this grid threw
    double to_go;         ///< Seconds that the rest will take, from the pace so far and the costs
};
using OnProgress = std::function<void(const Progress&)>;

/// A study to be run.
struct Task {
    Study study;
    /// None: all of the study's own. Gates that need another of the study's own are then left
    /// ungated.
    std::optional<std::vector<int>> grids = {};
    double seconds = 1.0;  ///< What all of the study's own grids are expected to take
};

/// What has become of a task.
struct StudyResult {
    std::vector<int> grids;         ///< Those that were run
    std::vector<GateResult> gates;  ///< One for each row, in the order written
    double seconds;                 ///< Sum over its runs
};

/// Runs all grids of all tasks out of one queue, the dearest first, as many at a time as the
/// machine has cores, and judges every row. A run that throws fails every gate that needs it, with
/// the reason; it stops nothing else. `on_progress` is called from one thread at a time. \throws
/// std::invalid_argument if a study has nothing to measure, no grid or no gate.
std::vector<StudyResult> run(const std::vector<Task>& tasks, const OnProgress& on_progress = {});

/// The same for one study, on its own grids or on `grids` if any are given.
std::vector<GateResult> run(const Study& study, std::vector<int> grids = {},
                            const OnProgress& on_progress = {});

}  // namespace crawford::reports
