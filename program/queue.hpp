/// The queue of jobs, told to whoever watches.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include "base/job_queue.hpp"
#include "program/narrator.hpp"

namespace crawford {

/// Runs all jobs (base/job_queue.hpp), so many at a time if `threads` says it, tells what goes on and how long it will take, and calls
/// `failed`, one at a time, for those that throw.
void run_told(std::vector<Job> jobs, Narrator& narrator, std::optional<unsigned> threads,
              const std::function<void(const Job&, std::exception_ptr)>& failed);

}  // namespace crawford
