/// A directory that nobody else has, removed with everything in it.
#pragma once

#include <filesystem>

namespace crawford {

class Scratch {
public:
    /// Makes one below the system's directory of temporary files.
    /// \throws InputError if it cannot.
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace crawford
