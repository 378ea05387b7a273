/// From what was typed to what is to be done.
#pragma once

#include <functional>
#include <variant>

#include "program/commands.hpp"

namespace crawford {

/// One command with its options, ready to go.
using Action = std::function<int()>;

/// Help or version, asked for: text for stdout.
struct Answer {
    std::string text;
};

/// Reads the command line.
/// \throws InputError, one line, for an unknown command or option (with the nearest one), a missing
/// one, or a value that cannot be read.
std::variant<Action, Answer> read_command_line(const CommandLine& arguments);

}  // namespace crawford
