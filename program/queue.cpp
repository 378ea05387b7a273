#include "program/queue.hpp"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

#include "base/terminal.hpp"

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds between_glances{1};

std::string text(const QueueStanding& standing) {
    return fmt::format("{} of {}, {} to go", standing.ended, standing.total,
                       clock_time(standing.to_go));
}

}  // namespace

void run_told(std::vector<Job> jobs, Narrator& narrator, std::optional<unsigned> threads,
              const std::function<void(const Job&, std::exception_ptr)>& failed) {
    auto last_told = Clock::now();
    const auto progress = [&](const Job& job, double done, const QueueStanding& standing) {
        if (Clock::now() - last_told < between_glances) return;
        last_told = Clock::now();
        narrator.glance(fmt::format("{}: {:.0f} %; {}", job.name, 100.0 * done, text(standing)));
    };
    const auto ended = [&](const Job& job, double seconds, const std::exception_ptr& failure,
                           const QueueStanding& standing) {
        narrator.say(fmt::format("{}: {} {:.1f} s; {}", job.name,
                                 failure ? "failed after" : "done in", seconds, text(standing)));
        if (failure) failed(job, failure);
    };
    run_jobs(std::move(jobs), {.progress = progress, .ended = ended}, threads);
}

}  // namespace crawford
