/// What a result says of where it came from.
#pragma once

#include <nlohmann/json.hpp>

#include "program/commands.hpp"

namespace crawford {

/// What every result of the program carries: version, revision, compiler, libraries, machine and
/// the command line.
nlohmann::ordered_json provenance(const CommandLine& command);

}  // namespace crawford
