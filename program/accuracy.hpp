/// A wanted accuracy of the regression rate: the preset that promises it, and what became of it.
#pragma once

#include <optional>
#include <string>

#include "program/commands.hpp"
#include "solver/run/burn.hpp"
#include "solver/run/preset.hpp"

namespace crawford {

/// Those of cases/scenes/presets, the cheapest first.
std::vector<Preset> presets();

/// As --help shows them: a line each, with what they were measured to be off by.
std::string presets_in_words();

/// What --preset or --accuracy ask for; nothing if neither is there.
/// \throws InputError if there is none of that name, the accuracy is no number or no preset is that
/// accurate.
std::optional<Preset> wanted_preset(const BurnSceneOptions& options);

/// The scene with what the preset chooses; what --set names stays as it is set.
/// \param told where not null, gets what was chosen, in words, a line each
Scene scene_at(const BurnSceneOptions& options, const Preset& preset,
               std::vector<std::string>* told);

/// V over the second half of a burn, here and on half the grid.
struct AccuracyFound {
    double regression_rate;  ///< [m/s]
    double coarser;          ///< [m/s]
    /// Estimated, relative: what is left of the change, but no less than was found elsewhere, since at
    /// the notch of a strip two grids may be off alike.
    double error;
    double seconds;  ///< that the check took
};

/// Burns it again, coarser.
/// \throws NumericalFailure if that fails.
AccuracyFound check_accuracy(const Scene& scene, const Preset& preset, const BurnOutcome& outcome,
                             const std::filesystem::path& history);

}  // namespace crawford
