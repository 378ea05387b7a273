/// What an earlier run of a scene has left in its folder, for `burn --resume`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

struct LeftOff {
    bool is_done = false;                             ///< with all the output that is asked for
    std::optional<std::filesystem::path> checkpoint;  ///< to go on from; none where there is none
};

/// Looks for what a run of this scene, called `name`, has left by the same sources of the solver:
/// others would end in other bits. One that has been killed goes on from its last checkpoint that
/// is sound and before the last row of its history: at that row it may have been at its end.
/// \param computed what checkpoints may be of, canonical TOML: the scene, and what is computed of it
/// \throws InputError if the manifest there is damaged.
LeftOff left_off(const std::filesystem::path& folder, const std::string& name, const Scene& scene,
                 const std::vector<std::string>& computed);

}  // namespace crawford
