/// What options of all commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "program/help.hpp"

namespace crawford {

/// An empty name is what an unset variable leaves of a path.
inline CLI::Option* refuse_empty(CLI::Option* option) {
    return option->check([](const std::string& path) {
        return path.empty() ? std::string("is empty; name a path or leave it out") : std::string();
    });
}

inline void add_footer(CLI::App* command, const std::string& examples) {
    command->footer(examples + '\n' + help::exit_codes);
}

}  // namespace crawford
