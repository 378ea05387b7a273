#include "base/job_queue.hpp"

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class Queue {
public:
    Queue(std::vector<Job> jobs, const QueueObserver& observer, unsigned threads)
        : jobs_(std::move(jobs)), observer_(observer), done_(jobs_.size(), 0.0) {
        std::ranges::stable_sort(jobs_, std::greater{}, &Job::expected_seconds);
        threads_ = unsigned(std::min<size_t>(std::max(1U, threads), jobs_.size()));
    }

    void run() {
        std::vector<std::future<void>> workers;
        for (unsigned k = 0; k < threads_; ++k)
            workers.push_back(std::async(std::launch::async, [this] { take_jobs(); }));
        for (auto& worker : workers) worker.get();
    }

private:
    void take_jobs() {
        for (auto mine = take(); mine; mine = take()) {
            const auto start = Clock::now();
            std::exception_ptr failure;
            try {
                jobs_[*mine].work([this, k = *mine](double done) { progress(k, done); });
            } catch (...) {
                failure = std::current_exception();
            }
            end(*mine, seconds_since(start), failure);
        }
    }

    std::optional<size_t> take() {
        const std::scoped_lock lock(mutex_);
        if (next_ == jobs_.size()) return {};
        return next_++;
    }

    void progress(size_t job, double done) {
        const std::scoped_lock lock(mutex_);
        done_[job] = done;
        if (observer_.progress) observer_.progress(jobs_[job], done, standing());
    }

    void end(size_t job, double seconds, const std::exception_ptr& failure) {
        const std::scoped_lock lock(mutex_);
        ++ended_;
        done_[job] = 1.0;
        if (observer_.ended) observer_.ended(jobs_[job], seconds, failure, standing());
    }

    QueueStanding standing() const {
        double done = 0.0;
        std::vector<double> remaining;
        for (size_t k = 0; k < jobs_.size(); ++k) {
            done += done_[k] * jobs_[k].expected_seconds;
            remaining.push_back((1.0 - done_[k]) * jobs_[k].expected_seconds);
        }
        return {ended_, jobs_.size(),
                time_to_go(remaining, done, seconds_since(started_), threads_)};
    }

    std::vector<Job> jobs_;
    const QueueObserver& observer_;
    std::vector<double> done_;  ///< part of each job, 0 to 1
    unsigned threads_ = 1;
    std::mutex mutex_;
    size_t next_ = 0, ended_ = 0;
    Clock::time_point started_ = Clock::now();
};

}  // namespace

void run_jobs(std::vector<Job> jobs, const QueueObserver& observer,
              std::optional<unsigned> threads) {
    Queue(std::move(jobs), observer, threads.value_or(std::thread::hardware_concurrency())).run();
}

double time_to_go(const std::vector<double>& remaining, double done, double elapsed,
                  unsigned threads) {
    const double work = std::accumulate(remaining.begin(), remaining.end(), 0.0);
    const double longest = remaining.empty() ? 0.0 : std::ranges::max(remaining);
    // Until something is done, what was expected is all there is to go by.
    const double pace = done > 0.0 && elapsed > 0.0 ? elapsed * threads / done : 1.0;
    return pace * std::max(longest, work / threads);
}

}  // namespace crawford
