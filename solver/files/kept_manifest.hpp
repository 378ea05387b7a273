/// The manifest of a burn, read again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/files/manifest.hpp"

namespace crawford {

struct KeptManifest {
    ManifestOutcome outcome;
    std::string solver_fingerprint;  ///< of what burnt it
    std::vector<std::string> command;
    std::string scene;  ///< canonical TOML
    std::vector<std::uint64_t> seeds;
    std::string restarted_from;  ///< a checkpoint, or nothing
    long last_step = 0;
    double time = 0.0;                           ///< reached [s]
    std::map<std::string, std::string> remarks;  ///< name -> text
    std::optional<RunResults> results;           ///< of a run that is done
};

/// Reads manifest.json in `folder`. Nothing if there is none, or if it is not of a burn: figures and other programs have theirs.
/// \throws InputError naming the file and what is wrong in it: it is no JSON, a member is missing or of another kind.
std::optional<KeptManifest> kept_manifest(const std::filesystem::path& folder);

}  // namespace crawford
