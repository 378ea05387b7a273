#include "reports/grid_runs.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <numeric>
#include <thread>

namespace crawford::reports {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

GridRun run_one(const GridJob& job) {
    const auto start = Clock::now();
    GridRun run{job.grid, {}, {}, 0.0};
    try {
        run.measurement = job.study->measure()(job.grid);
    } catch (const std::exception& problem) {
        run.failure = problem.what();
    } catch (...) {
        run.failure = "unknown exception";
    }
    run.seconds = seconds_since(start);
    return run;
}

/// What is left to do, handed out one by one to whoever asks.
class Queue {
public:
    Queue(const std::vector<GridJob>& jobs, const OnProgress& on_progress)
        : jobs_(jobs), on_progress_(on_progress), order_(jobs.size()), runs_(jobs.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        std::ranges::stable_sort(order_, std::greater{}, [&](size_t i) { return jobs[i].cost; });
        for (const auto& job : jobs) cost_to_go_ += job.cost;
    }

    void work() {
        for (auto mine = take(); mine; mine = take()) {
            auto run = run_one(jobs_[*mine]);
            put(*mine, std::move(run));
        }
    }

    std::vector<GridRun> runs() && { return std::move(runs_); }

private:
    std::optional<size_t> take() {
        const std::scoped_lock lock(mutex_);
        if (next_ == order_.size()) return {};
        return order_[next_++];
    }

    void put(size_t i, GridRun run) {
        const std::scoped_lock lock(mutex_);
        runs_[i] = std::move(run);
        ++done_;
        cost_done_ += jobs_[i].cost;
        cost_to_go_ -= jobs_[i].cost;
        if (!on_progress_) return;
        const double pace = cost_done_ > 0.0 ? seconds_since(started_) / cost_done_ : 0.0;
        on_progress_({jobs_[i].study->name(), jobs_[i].grid, runs_[i].seconds, done_, jobs_.size(),
                      runs_[i].failure, pace * std::max(0.0, cost_to_go_)});
    }

    const std::vector<GridJob>& jobs_;
    const OnProgress& on_progress_;
    std::vector<size_t> order_;
    std::vector<GridRun> runs_;
    std::mutex mutex_;
    size_t next_ = 0, done_ = 0;
    double cost_done_ = 0.0, cost_to_go_ = 0.0;
    Clock::time_point started_ = Clock::now();
};

}  // namespace

std::vector<GridRun> run_grids(const std::vector<GridJob>& jobs, const OnProgress& on_progress) {
    Queue queue(jobs, on_progress);
    const size_t cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::future<void>> workers;
    for (size_t i = 0; i < std::min(cores, jobs.size()); ++i)
        workers.push_back(std::async(std::launch::async, [&] { queue.work(); }));
    for (auto& worker : workers) worker.get();
    return std::move(queue).runs();
}

}  // namespace crawford::reports
