#include "cases/program/narrator.hpp"

#include <fmt/format.h>

#include <iostream>

#include "solver/output/progress.hpp"

namespace crawford {

namespace {

constexpr std::chrono::seconds between_lines{5};

}  // namespace

Narrator::Narrator(bool quiet) : quiet_(quiet), terminal_(stderr_is_terminal()) {}

void Narrator::say(const std::string& line) {
    if (quiet_) return;
    const std::scoped_lock lock(mutex_);
    std::cerr << line << '\n';
}

void Narrator::progress(const std::string& what, double done) {
    if (quiet_ || !terminal_) return;
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    auto& course = courses_.try_emplace(what, Course{now, now}).first->second;
    if (done <= 0.0 || now - course.last_told < between_lines) return;
    course.last_told = now;
    const std::chrono::duration<double> elapsed = now - course.started;
    std::cerr << fmt::format("{}: {:.0f} %, {} to go\n", what, 100.0 * done,
                             clock_time(elapsed.count() * (1.0 - done) / done));
}

}  // namespace crawford
