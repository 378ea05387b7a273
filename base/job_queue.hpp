/// One queue for all that runs side by side, and one answer to how long it will take.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace crawford {

/// Something to do. Jobs run in several threads at the same time: they share nothing that changes.
struct Job {
    /// Tells how much of the job is done, 0 to 1.
    using Progress = std::function<void(double done)>;

    std::string name;
    double expected_seconds;  ///< roughly; decides what begins first and what is said of the rest
    std::function<void(const Progress&)> work;
};

/// How far the whole queue has come.
struct QueueStanding {
    std::size_t ended = 0, total = 0;
    double to_go = 0.0;  ///< seconds that the rest will take, from the pace so far
};

/// Who wants to know. Each is called from one thread at a time; any may be left out.
struct QueueObserver {
    std::function<void(const Job&, double done, const QueueStanding&)> progress = {};
    /// `seconds` of wall time that the job took; `failure` is what it threw, or null.
    std::function<void(const Job&, double seconds, std::exception_ptr failure,
                       const QueueStanding&)>
        ended = {};
};

/// Runs all jobs, the longest first so that it does not wait for the short ones, as many at a time
/// as `threads` says, or else as this process may use cores. A job that throws stops no other.
void run_jobs(std::vector<Job> jobs, const QueueObserver& observer = {},
              std::optional<unsigned> threads = {});

/// Time to go [s] for what remains of some jobs, in seconds that were expected of them, when `done`
/// of such seconds have taken `elapsed` on `threads` threads: the work that is left, shared out,
/// but never less than the longest job that is left takes.
double time_to_go(const std::vector<double>& remaining, double done, double elapsed,
                  unsigned threads);

}  // namespace crawford
