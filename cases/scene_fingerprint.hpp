/// What the answer of a study depends on: the program, its libraries, and the scenes that it reads.
#pragma once

#include <string>

namespace crawford {

/// Changes with a byte of the program, of a library that it has loaded, or of a file below
/// cases/scenes: scenes, presets and tables of discs are read when a study runs.
/// \throws InputError if one of them cannot be read.
std::string fingerprint_with_scenes();

}  // namespace crawford
