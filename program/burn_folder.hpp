/// The folder that `crawford burn` writes into: one run at a time, one scene for good.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "solver/files/kept_manifest.hpp"

namespace crawford {

/// Holds a folder as long as it lives, with a file `<folder>/.owner` that says who: host, process,
/// when that process began.
class BurnFolder {
public:
    /// Takes over from a process of this host that has ended, and from one of another host whose
    /// file has not been touched for two minutes.
    /// \throws InputError naming the owner if another run holds the folder, or if it cannot be
    /// written.
    explicit BurnFolder(const std::filesystem::path& folder);
    ~BurnFolder();
    BurnFolder(const BurnFolder&) = delete;
    BurnFolder& operator=(const BurnFolder&) = delete;

    /// Says that the run goes on; touches the file every few seconds at most. Call it each step.
    void beat();

private:
    std::filesystem::path file_;
    bool is_new_;  ///< the folder: if nothing is put into it, it goes again
    std::chrono::steady_clock::time_point last_beat_ = std::chrono::steady_clock::now();
};

/// Whether a run holds the folder now, as far as can be seen from here.
bool is_held(const std::filesystem::path& folder);

/// The manifest of the burn that lies in a folder, if there is one.
/// \throws InputError if it is damaged: it does not say whose results they are, and they are not to
/// be lost for it.
std::optional<KeptManifest> manifest_there(const std::filesystem::path& folder);

/// What a run is to put into a folder.
struct Burning {
    std::string name;             ///< what its files' names begin with
    std::filesystem::path scene;  ///< as typed
    std::string toml;             ///< canonical
    bool folder_was_named;        ///< by --out
};

/// \throws InputError if the folder holds the results of a scene of another name; or of this name
/// where a key differs, which is named, unless the folder was named and the scene file is the same.
void refuse_results_of_others(const std::filesystem::path& folder, const Burning& burning,
                              bool goes_on);

/// Removes the snapshots, series, history, checkpoints and manifest of the runs of that name.
void remove_results(const std::filesystem::path& folder, const std::string& name);

}  // namespace crawford
