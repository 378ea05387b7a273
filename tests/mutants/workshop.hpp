/// Builds a tree of sources and lets the judges look at what came out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fault.hpp"

namespace crawford::mutants {

/// What one judge saw of one fault.
struct Finding {
    std::vector<std::string> gates;  ///< that fell short, or how it ended otherwise; none if it saw
                                     ///< nothing
    double seconds = 0.0;            ///< to judge, without the build

    bool killed() const { return !gates.empty(); }
};

class Workshop {
public:
    /// Configures a build of `tree` in `work`/build.
    /// \throws std::runtime_error with what was said, if that fails.
    Workshop(std::filesystem::path tree, std::filesystem::path work, int jobs);

    /// Builds what the judge looks at.
    /// \returns what the compiler said, if it failed; nothing if all went well
    std::string build(const Judge& judge) const;

    /// Lets the judge look, for at most `limit` seconds.
    Finding ask(const Judge& judge, double limit) const;

private:
    Finding ask_study(const std::string& study, double limit) const;
    Finding ask_tests(const std::string& filter, double limit) const;

    std::filesystem::path tree_;
    std::filesystem::path work_;
    std::filesystem::path build_;
    int jobs_;
};

}  // namespace crawford::mutants
