#include "reports/grid_runs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <thread>

namespace crawford::reports {
namespace {

using Clock = std::chrono::steady_clock;

GridRun run_one(const Measure& measure, int grid) {
    const auto start = Clock::now();
    GridRun run{grid, {}, {}, 0.0};
    try {
        run.measurement = measure(grid);
    } catch (const std::exception& problem) {
        run.failure = problem.what();
    } catch (...) {
        run.failure = "unknown exception";
    }
    run.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return run;
}

}  // namespace

std::vector<GridRun> run_grids(const Study& study, std::vector<int> grids,
                               const OnProgress& on_progress) {
    std::ranges::sort(grids);
    grids.erase(std::unique(grids.begin(), grids.end()), grids.end());

    std::vector<GridRun> runs(grids.size());
    std::atomic<std::size_t> next = 0;
    std::size_t done = 0;
    std::mutex reporting;
    const auto work = [&] {
        for (std::size_t taken = next++; taken < grids.size(); taken = next++) {
            const std::size_t i = grids.size() - 1 - taken;
            runs[i] = run_one(study.measure(), grids[i]);
            const std::scoped_lock lock(reporting);
            ++done;
            if (on_progress)
                on_progress(
                    {study.name(), grids[i], runs[i].seconds, done, grids.size(), runs[i].failure});
        }
    };

    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::future<void>> workers;
    for (std::size_t i = 0; i < std::min(threads, grids.size()); ++i)
        workers.push_back(std::async(std::launch::async, work));
    for (auto& worker : workers) worker.get();
    return runs;
}

}  // namespace crawford::reports
