/// Burns as jobs.
#pragma once

#include <filesystem>
#include <vector>

#include "base/job_queue.hpp"
#include "cases/registry.hpp"

namespace crawford {

/// One job for each run of these scenes that is not kept under `out`: each run once, with the
/// output that serves all who ask for it.
std::vector<Job> burnings(const std::vector<Scene>& scenes, const std::filesystem::path& out);

}  // namespace crawford
