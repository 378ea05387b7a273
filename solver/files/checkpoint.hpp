/// Checkpoints: all that a run needs to go on, bit for bit.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/files/provenance.hpp"
#include "solver/files/sample.hpp"
#include "solver/files/step_choice.hpp"
#include "solver/step/state.hpp"

namespace crawford {

/// What a run remembers beside its state.
struct RunMemory {
    std::vector<Sample> window;                       ///< of what is watched for steadiness
    std::optional<StepChoice> choice = std::nullopt;  ///< where steps are chosen
};

struct Checkpoint {
    State state;
    RunMemory memory;
};

/// "<directory>/<name>_checkpoint_<step>.h5", where a run called `name` puts them.
std::filesystem::path checkpoint_file(const std::filesystem::path& directory,
                                      const std::string& name, long step);

/// Writes HDF5: the group /state, the window, the scene's text and where it comes from.
/// \throws InputError if the file cannot be written; nothing is then left under its name.
void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                     const Provenance& provenance);

/// Whether a run of this scene may go on from it.
/// \throws InputError if the file is missing, damaged or no checkpoint.
bool is_checkpoint_of(const std::filesystem::path& path, const std::string& scene);

/// Reads it back.
/// \throws InputError if the file is missing, damaged or no checkpoint, or was written for another
/// scene; the message then names the key that differs.
Checkpoint load_checkpoint(const std::filesystem::path& path, const std::string& scene);

}  // namespace crawford
