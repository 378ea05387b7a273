/// Long tasks side by side, and one answer to how long they will take.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "program/narrator.hpp"

namespace crawford {

struct Task {
    using Progress = std::function<void(const std::string& what, double done)>;

    std::string name;
    double expected_seconds;  ///< roughly; decides what begins first and what is said of the rest
    std::function<void(const Progress&)> work;
};

/// Time to go [s] for what remains of some tasks, in seconds that were expected of them, when
/// `done` of such seconds have taken `elapsed` on `threads` threads: the work that is left, shared
/// out, but never less than the longest task that is left takes.
double time_to_go(const std::vector<double>& remaining, double done, double elapsed,
                  unsigned threads);

class Workload {
public:
    explicit Workload(Narrator& narrator) : narrator_(narrator) {}

    /// Runs them all, the longest first, on as many threads as the machine has cores. One that
    /// throws stops no other: `failed` is told, one at a time.
    void run(std::vector<Task> tasks,
             const std::function<void(const Task&, std::exception_ptr)>& failed);

private:
    using Clock = std::chrono::steady_clock;

    void take_tasks(const std::function<void(const Task&, std::exception_ptr)>& failed);
    void progress(const Task& task, double done);
    void finish(const Task& task, double seconds, std::exception_ptr failure,
                const std::function<void(const Task&, std::exception_ptr)>& failed);
    std::string standing() const;

    Narrator& narrator_;
    std::mutex mutex_;
    std::vector<Task> tasks_;
    size_t next_ = 0;
    size_t ended_ = 0;
    unsigned threads_ = 1;
    std::map<const Task*, double> done_;  ///< part of each that has begun, 0 to 1
    Clock::time_point started_;
    Clock::time_point last_told_;
};

}  // namespace crawford
