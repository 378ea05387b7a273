/// Kept runs (solver/run/kept_runs.hpp) as cases ask for them.
#pragma once

#include <filesystem>
#include <memory>

#include "cases/registry.hpp"
#include "solver/run/kept_runs.hpp"
#include "solver/run/run_identity.hpp"

namespace crawford {

using Burn = KeptRun;

/// Those in request.out/burns; without request.out, in a directory that this program removes when
/// it ends.
KeptRuns kept_runs(const std::filesystem::path& out);

/// \throws as KeptRuns::get
std::shared_ptr<const Burn> kept_burn(const Scene& scene, const Request& request);

}  // namespace crawford
