#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/job_queue.hpp"
#include "reports/judge_rows.hpp"
#include "reports/study.hpp"

namespace crawford::reports {
namespace {

void check(const Study& study) {
    if (!study.run()) throw std::invalid_argument(study.name() + ": nothing to measure");
    if (study.rows().empty()) throw std::invalid_argument(study.name() + ": no gate");
}

/// Ascending and each once.
std::vector<int> grids_of(const Task& task) {
    check(task.study);
    auto grids = task.grids.value_or(task.study.grids());
    if (!task.grids && grids.empty()) throw std::invalid_argument(task.study.name() + ": no grid");
    std::ranges::sort(grids);
    grids.erase(std::unique(grids.begin(), grids.end()), grids.end());
    return grids;
}

/// Share of the study's cost: taken to grow as the number of cells in two dimensions. Settings of a
/// list cost alike.
double cost_of(const Task& task, int grid) {
    if (task.study.is_a_list()) return task.seconds / double(task.study.grids().size());
    double whole = 0.0;
    for (const int own : task.study.grids()) whole += double(own) * own;
    return task.seconds * double(grid) * grid / std::max(1.0, whole);
}

/// One run of one study, and its record when there is one.
struct Run {
    const Task* task;
    int grid;
    std::optional<Record> record = {};
};

StudyResult judged(const Task& task, const std::vector<Run>& runs) {
    StudyResult result{.grids = {}, .gates = {}, .seconds = 0.0};
    std::vector<GridRun> found;
    for (const Run& run : runs) {
        result.grids.push_back(run.grid);
        found.push_back(grid_run(task.study, *run.record));
        result.seconds += found.back().seconds;
    }
    result.gates = judge_rows(task.study, found);
    return result;
}

std::string name_of(const Run& run) {
    return fmt::format("{}: {}", run.task->study.name(), run.task->study.setting(run.grid).text());
}

void make(const std::vector<Run*>& missing, RecordStore* store, const OnProgress& on_progress,
          std::optional<unsigned> threads) {
    std::vector<Job> jobs;
    std::map<std::string, const Run*> run_of;
    for (Run* const run : missing) {
        jobs.push_back(
            {name_of(*run), cost_of(*run->task, run->grid), [run, store](const Job::Progress&) {
                 const Study& study = run->task->study;
                 run->record = record_of(study.name(), study.setting(run->grid), study.run());
                 if (store != nullptr) store->add(*run->record);
             }});
        if (!run_of.emplace(jobs.back().name, run).second)
            throw std::invalid_argument(jobs.back().name + ": asked for twice");
    }
    std::exception_ptr cannot_keep;
    run_jobs(std::move(jobs),
             {.ended =
                  [&](const Job& job, double seconds, const std::exception_ptr& problem,
                      const QueueStanding& standing) {
                      if (problem) cannot_keep = problem;
                      const auto& record = run_of.at(job.name)->record;
                      // Where memory was short there is none.
                      if (record && on_progress)
                          on_progress({record->experiment, record->setting, seconds, standing.ended,
                                       standing.total, record->ending.message, standing.to_go});
                  }},
             threads);
    if (cannot_keep) std::rethrow_exception(cannot_keep);
}

}  // namespace

std::vector<StudyResult> run(const std::vector<Task>& tasks, RecordStore* store,
                             const OnProgress& on_progress, std::optional<unsigned> threads) {
    std::vector<std::vector<Run>> runs;
    for (const Task& task : tasks) {
        auto& own = runs.emplace_back();
        for (const int grid : grids_of(task)) own.push_back({&task, grid});
    }
    std::vector<Run*> missing;
    for (auto& own : runs)
        for (Run& run : own) {
            const Study& study = run.task->study;
            if (store != nullptr) run.record = store->find(study.name(), study.setting(run.grid));
            if (!run.record) missing.push_back(&run);
        }
    std::vector<size_t> kept;
    for (const auto& own : runs)
        kept.push_back(size_t(
            std::ranges::count_if(own, [](const Run& run) { return run.record.has_value(); })));
    make(missing, store, on_progress, threads);
    std::vector<StudyResult> results;
    for (size_t k = 0; k < tasks.size(); ++k) {
        results.push_back(judged(tasks[k], runs[k]));
        results.back().kept = kept[k];
    }
    return results;
}

std::vector<StudyResult> judge_kept(const std::vector<Task>& tasks, RecordStore& store) {
    std::vector<StudyResult> results;
    for (const Task& task : tasks) {
        std::vector<Run> runs;
        bool is_foreign = false;
        for (const int grid : grids_of(task)) {
            auto record = store.newest(task.study.name(), task.study.setting(grid));
            if (!record) continue;
            is_foreign = is_foreign || record->fingerprint != store.fingerprint();
            runs.push_back({&task, grid, std::move(record)});
        }
        results.push_back(judged(task, runs));
        results.back().kept = runs.size();
        results.back().is_foreign = is_foreign;
    }
    return results;
}

std::vector<GateResult> run(const Study& study, std::vector<int> grids,
                            const OnProgress& on_progress) {
    Task task{study};
    if (!grids.empty()) task.grids = std::move(grids);
    return run({std::move(task)}, nullptr, on_progress).front().gates;
}

}  // namespace crawford::reports
