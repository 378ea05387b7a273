/// Burns as tasks.
#pragma once

#include <filesystem>
#include <vector>

#include "cases/registry.hpp"
#include "program/workload.hpp"

namespace crawford {

/// One task for each of the scenes whose burn is not kept under `out`, equal ones once.
std::vector<Task> burnings(const std::vector<Scene>& scenes, Fidelity fidelity,
                           const std::filesystem::path& out);

}  // namespace crawford
