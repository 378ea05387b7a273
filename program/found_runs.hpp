/// The burns that lie somewhere below a folder, whoever made them: `burn`, a figure, an ensemble.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/files/manifest.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

enum class RunState {
    done,
    running,    ///< somebody writes into its folder
    cut_off,    ///< killed or interrupted: it can go on
    failed,     ///< its numbers did
    unreadable  ///< its manifest cannot be understood
};

/// "done", "running", "cut off", "failed", "unreadable".
std::string name_of(RunState state);

struct FoundRun {
    std::filesystem::path folder;
    RunState state = RunState::unreadable;
    std::string reason;              ///< why it failed, was cut off or cannot be read, if known
    std::string key;                 ///< of the scene (run_identity.hpp)
    std::string name;                ///< what its files' names begin with; empty without a history
    std::optional<Scene> scene;      ///< none if unreadable
    std::string solver_fingerprint;  ///< of what burnt it
    std::vector<std::uint64_t> seeds;
    double time = 0.0;  ///< reached [s]
    std::optional<RunResults> results;
    std::map<std::string, std::string> remarks;  ///< name -> text
};

/// In the order of their folders' names.
/// \throws InputError if there is no such folder, or if a part of it cannot be looked into.
std::vector<FoundRun> found_runs(const std::filesystem::path& below);

}  // namespace crawford
