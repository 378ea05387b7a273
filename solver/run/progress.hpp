/// Progress and time to go, on a terminal, on one line that is written over and over.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

namespace crawford {

/// Where a run stands.
struct Standing {
    long step;
    double time;            ///< [s]
    double mean_burn_rate;  ///< [m/s]
};

/// The line, at most 79 characters, so that no terminal of 80 columns breaks it.
std::string progress_line(const Standing& standing, long last_step, double seconds_to_go);

class Progress {
public:
    /// Writes to `terminal`, unless it is not `shown`.
    Progress(std::ostream& terminal, bool shown, long first_step);
    ~Progress();  ///< leaves the line standing and begins a new one, for what is printed next
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// At most ten times a second, and at the last step, which may be an estimate. The time to go follows from the mean pace
    /// so far.
    void show(const Standing& standing, long last_step);

private:
    using Clock = std::chrono::steady_clock;

    std::ostream& terminal_;
    bool shown_;
    long first_step_;
    Clock::time_point started_ = Clock::now();
    Clock::time_point next_ = started_;
    bool line_open_ = false;
};

}  // namespace crawford
