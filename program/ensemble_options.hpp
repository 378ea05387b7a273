/// Commands for many burns: runs, gather. Exit codes as in commands.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crawford {

struct RunsOptions {
    bool list = false;
    std::filesystem::path key;     ///< a scene file, to say its key; empty if the list is wanted
    std::vector<std::string> set;  ///< "dotted.key=value", of that scene
    std::filesystem::path out = "out";
    bool json = false;
};

struct GatherOptions {
    std::vector<std::filesystem::path> folders;
    std::filesystem::path from;  ///< a file that names more of them, one a line; empty if none
    std::filesystem::path out;
    std::string after;                ///< time from which on a burn counts, with its unit
    std::string interval = "1 %";     ///< half-width that is wanted, of the mean
    std::string confidence = "95 %";  ///< that the mean of all packs lies within an interval
    std::string title = "Ensemble";
};

/// Prints what burns lie below a folder, or the key that a scene is known by.
/// \throws InputError if the scene is wrong or there is no such folder.
int runs(const RunsOptions& options);

/// Makes tables (CSV, JSON) and a page of the burns below folders.
/// \throws InputError if a folder has none or they cannot be told apart.
int gather(const GatherOptions& options, const std::vector<std::string>& command);

}  // namespace crawford
