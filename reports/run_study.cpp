#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "reports/grid_runs.hpp"
#include "reports/judge_rows.hpp"
#include "reports/study.hpp"

namespace crawford::reports {
namespace {

void check(const Study& study) {
    if (!study.measure()) throw std::invalid_argument(study.name() + ": nothing to measure");
    if (study.rows().empty()) throw std::invalid_argument(study.name() + ": no gate");
}

/// Ascending and each once.
std::vector<int> grids_of(const Task& task) {
    auto grids = task.grids.value_or(task.study.grids());
    if (!task.grids && grids.empty()) throw std::invalid_argument(task.study.name() + ": no grid");
    std::ranges::sort(grids);
    grids.erase(std::unique(grids.begin(), grids.end()), grids.end());
    return grids;
}

/// Share of the study's cost: taken to grow as the number of cells in two dimensions.
double cost_of(const Task& task, int grid) {
    double whole = 0.0;
    for (const int own : task.study.grids()) whole += double(own) * own;
    return task.seconds * double(grid) * grid / std::max(1.0, whole);
}

}  // namespace

std::vector<StudyResult> run(const std::vector<Task>& tasks, const OnProgress& on_progress) {
    std::vector<GridJob> jobs;
    std::vector<StudyResult> results;
    for (const auto& task : tasks) {
        check(task.study);
        results.push_back({grids_of(task), {}, 0.0});
        for (const int grid : results.back().grids)
            jobs.push_back({&task.study, grid, cost_of(task, grid)});
    }

    auto runs = run_grids(jobs, on_progress);
    auto next = runs.begin();
    for (std::size_t k = 0; k < tasks.size(); ++k) {
        const auto end = next + std::ptrdiff_t(results[k].grids.size());
        const std::vector<GridRun> own(std::make_move_iterator(next), std::make_move_iterator(end));
        next = end;
        results[k].gates = judge_rows(tasks[k].study, own);
        for (const auto& run : own) results[k].seconds += run.seconds;
    }
    return results;
}

std::vector<GateResult> run(const Study& study, std::vector<int> grids,
                            const OnProgress& on_progress) {
    Task task{study};
    if (!grids.empty()) task.grids = std::move(grids);
    return run({std::move(task)}, on_progress).front().gates;
}

}  // namespace crawford::reports
