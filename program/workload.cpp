#include "program/workload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <thread>
#include <utility>

#include "base/progress.hpp"

namespace crawford {

namespace {

constexpr std::chrono::seconds between_glances{1};

double seconds_between(std::chrono::steady_clock::time_point a,
                       std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

}  // namespace

double time_to_go(const std::vector<double>& remaining, double done, double elapsed,
                  unsigned threads) {
    const double work = std::accumulate(remaining.begin(), remaining.end(), 0.0);
    const double longest = remaining.empty() ? 0.0 : std::ranges::max(remaining);
    // Until something is done, what was expected is all there is to go by.
    const double pace = done > 0.0 && elapsed > 0.0 ? elapsed * threads / done : 1.0;
    return pace * std::max(longest, work / threads);
}

void Workload::run(std::vector<Task> tasks,
                   const std::function<void(const Task&, std::exception_ptr)>& failed) {
    tasks_ = std::move(tasks);
    std::ranges::stable_sort(tasks_, std::greater{}, &Task::expected_seconds);
    next_ = ended_ = 0;
    done_.clear();
    started_ = last_told_ = Clock::now();
    threads_ = unsigned(
        std::min<size_t>(std::max(1U, std::thread::hardware_concurrency()), tasks_.size()));
    std::vector<std::future<void>> workers;
    for (unsigned k = 0; k < threads_; ++k)
        workers.push_back(std::async(std::launch::async, [&] { take_tasks(failed); }));
    for (auto& worker : workers) worker.get();
}

void Workload::take_tasks(const std::function<void(const Task&, std::exception_ptr)>& failed) {
    while (true) {
        const Task* task = nullptr;
        {
            const std::scoped_lock lock(mutex_);
            if (next_ == tasks_.size()) return;
            task = &tasks_[next_++];
            done_[task] = 0.0;
        }
        const auto start = Clock::now();
        std::exception_ptr failure;
        try {
            task->work([&](const std::string&, double done) { progress(*task, done); });
        } catch (...) {
            failure = std::current_exception();
        }
        finish(*task, seconds_between(start, Clock::now()), failure, failed);
    }
}

void Workload::progress(const Task& task, double done) {
    const std::scoped_lock lock(mutex_);
    done_[&task] = done;
    if (Clock::now() - last_told_ < between_glances) return;
    last_told_ = Clock::now();
    narrator_.glance(fmt::format("{}: {:.0f} %; {}", task.name, 100.0 * done, standing()));
}

void Workload::finish(const Task& task, double seconds, std::exception_ptr failure,
                      const std::function<void(const Task&, std::exception_ptr)>& failed) {
    const std::scoped_lock lock(mutex_);
    ++ended_;
    done_[&task] = 1.0;
    narrator_.say(fmt::format("{}: {} {:.1f} s; {}", task.name,
                              failure ? "failed after" : "done in", seconds, standing()));
    if (failure) failed(task, failure);
}

std::string Workload::standing() const {
    double done = 0.0;
    std::vector<double> remaining;
    for (const Task& task : tasks_) {
        const auto begun = done_.find(&task);
        const double part = begun == done_.end() ? 0.0 : begun->second;
        done += part * task.expected_seconds;
        remaining.push_back((1.0 - part) * task.expected_seconds);
    }
    const double elapsed = seconds_between(started_, Clock::now());
    return fmt::format("{} of {}, {} to go", ended_, tasks_.size(),
                       clock_time(time_to_go(remaining, done, elapsed, threads_)));
}

}  // namespace crawford
