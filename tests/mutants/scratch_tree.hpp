/// A copy of the sources in which faults are put in and taken out again.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "fault.hpp"

namespace crawford::mutants {

class ScratchTree {
public:
    /// Makes `copy` equal to what git knows, or could know, of the working tree `sources`. Files
    /// that are equal already keep their time, so that a build of the copy goes on where it was.
    /// \throws std::runtime_error if `sources` is no working tree of git.
    ScratchTree(const std::filesystem::path& sources, std::filesystem::path copy);

    const std::filesystem::path& path() const { return copy_; }

    /// \throws std::runtime_error if the file cannot be read.
    std::string read(const std::string& file) const;

    /// A number for the contents of the files (relative paths) that `counts` wants to count.
    std::string fingerprint(const std::function<bool(const std::string&)>& counts) const;

    /// Names of all studies: those of the files below cases/ that register any.
    std::vector<std::string> studies() const;
    bool registers_studies(const std::string& file) const;

    /// The fault in its file, for as long as this lives.
    class Planted {
    public:
        /// \throws std::invalid_argument if the fault does not apply; the file then stays.
        Planted(const ScratchTree& tree, const Fault& fault);
        ~Planted();
        Planted(const Planted&) = delete;
        Planted& operator=(const Planted&) = delete;

    private:
        std::filesystem::path file_;
        std::string sound_;
    };

private:
    void mirror(const std::filesystem::path& from, const std::string& file);
    void remove_strangers() const;

    std::filesystem::path copy_;
    std::map<std::string, std::string> digests_;  ///< of each file
};

/// What the study in a file is called: "heat-time" in cases/verify/heat/heat_time.cpp.
std::string study_of(const std::string& file);

}  // namespace crawford::mutants
