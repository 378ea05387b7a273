/// Which machine code runs: the program itself and every library that was loaded with it.
#pragma once

#include <string>

namespace crawford {

/// Changes with any instruction or constant of the program or of a library it has loaded: a digest
/// of their build ids, which the linker makes of their contents. A library without one counts by
/// its file.
/// \throws InputError if such a file cannot be read.
std::string program_fingerprint();

}  // namespace crawford
