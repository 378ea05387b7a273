/// One run from a scene to files: what `crawford burn` does.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/files/step_choice.hpp"
#include "solver/guards/guard.hpp"
#include "solver/run/progress.hpp"
#include "solver/run/reduction.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

/// How far a run has come.
struct BurnProgress {
    long first_step, last_step;  ///< that it began after, and that it goes to
    Standing now;
};

struct BurnOptions {
    std::string name;                                     ///< what the files' names begin with
    std::filesystem::path directory;                      ///< where they go; created if missing
    std::optional<std::filesystem::path> restart = {};    ///< a checkpoint to go on from
    std::vector<std::string> command = {};                ///< the command line, for the manifest
    std::function<void(const BurnProgress&)> watch = {};  ///< told after each step
    /// Told each remark once, as soon as it is known: before the first step or during the run.
    std::function<void(const Guard&)> remark = {};
    std::function<bool()> interrupted = {};  ///< asked before each step: whether to leave off
};

struct BurnOutcome {
    long step;                         ///< the last
    double time;                       ///< reached [s]
    bool steady;                       ///< ended by time.until_steady
    bool interrupted;                  ///< left off before its end
    Summary summary;                   ///< of the last step
    double seconds;                    ///< wall time of the steps and their output
    long steps;                        ///< done by this run
    std::optional<StepCount> chosen;   ///< how they came about, where they were chosen
    std::vector<ModuleTime> timing;    ///< of each module
    std::filesystem::path checkpoint;  ///< of the last state
};

/// Runs what is left of a scene to time.end or until it is steady, and writes history, snapshots, checkpoints and
/// manifest.json. The last state always gets a snapshot and a checkpoint. Prints nothing.
/// \throws InputError before anything is computed if the checkpoint is not of this scene or the
/// directory is not writable, or if the scene's numbers are beyond a limit that no answer survives;
/// later if a file cannot be written.
/// \throws NumericalFailure if a step fails; snapshot and checkpoint of the last good state are
/// then written and named.
///
/// Checkpoints are of what is computed, everything else of the scene that was asked for.
BurnOutcome burn(const Reduction& reduction, const BurnOptions& options,
                 const Sources& sources = {});

/// A scene as it is written.
BurnOutcome burn(const Scene& scene, const BurnOptions& options, const Sources& sources = {});

}  // namespace crawford
