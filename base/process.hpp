/// A child process: run to its end, with what it wrote.
#pragma once

#include <string>
#include <vector>

namespace crawford {

/// How a program ended and what it said.
struct Finished {
    int status;          ///< Exit status; 128 + signal if it was killed
    std::string output;  ///< Standard output and standard error, together
};

/// Runs arguments[0], looked up in PATH, and waits for it. No shell stands between: arguments
/// arrive as they are. Standard input is empty.
/// \throws std::system_error if it cannot be started (not installed, say).
Finished run_program(const std::vector<std::string>& arguments);

}  // namespace crawford
