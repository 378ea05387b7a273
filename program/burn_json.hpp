/// How a burn has ended, as one line of JSON: for programs that start burns, as a workflow on a cluster.
#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include "solver/guards/guard.hpp"

namespace crawford {

struct BurnEnd {
    int exit_code = 0;
    std::filesystem::path out;  ///< empty where it was not known yet
    double seconds = 0.0;       ///< wall time of the whole command
    Guards remarks;             ///< that were made
    std::optional<std::filesystem::path> checkpoint = std::nullopt;  ///< of the last state
    std::string goes_on_with = "";         ///< the command, of a burn that was interrupted
    std::exception_ptr failure = nullptr;  ///< what ended it, if anything has
};

/// Without the end of the line. Of a burn that is done it holds the results that its manifest has.
std::string json_line(const BurnEnd& end);

}  // namespace crawford
