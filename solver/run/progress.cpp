#include "solver/run/progress.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/terminal.hpp"

namespace crawford {

namespace {

constexpr size_t columns = 79;

}  // namespace

std::string progress_line(const Standing& standing, long last_step, double seconds_to_go) {
    const double percent = 100.0 * double(standing.step) / double(last_step);
    const double cm = 1e-2, ms = 1e-3;
    return fmt::format("{:5.1f} %  step {} of {}  t = {:.2f} ms  r_b = {:.4f} cm/s  ETA {}",
                       percent, standing.step, last_step, standing.time / ms,
                       standing.mean_burn_rate / cm, clock_time(seconds_to_go))
        .substr(0, columns);
}

Progress::Progress(std::ostream& terminal, bool shown, long first_step)
    : terminal_(terminal), shown_(shown), first_step_(first_step) {}

Progress::~Progress() {
    if (line_open_) terminal_ << std::endl;
}

void Progress::show(const Standing& standing, long last_step) {
    const auto now = Clock::now();
    if (!shown_ || (now < next_ && standing.step < last_step)) return;
    next_ = now + std::chrono::milliseconds(100);
    const std::chrono::duration<double> elapsed = now - started_;
    const double pace = elapsed.count() / double(standing.step - first_step_);
    const std::string line =
        progress_line(standing, last_step, pace * double(last_step - standing.step));
    terminal_ << fmt::format("\r{:<{}}", line, columns) << std::flush;
    line_open_ = true;
}

}  // namespace crawford
