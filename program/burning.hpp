/// Burns as tasks.
#pragma once

#include <filesystem>
#include <vector>

#include "base/job_queue.hpp"
#include "cases/registry.hpp"

namespace crawford {

/// One task for each of the scenes whose burn is not kept under `out`, equal ones once.
std::vector<Job> burnings(const std::vector<Scene>& scenes, Fidelity fidelity,
                          const std::filesystem::path& out);

}  // namespace crawford
