/// What a result was computed on and with, as far as the system tells.
#pragma once

#include <string>

namespace crawford {

/// Processor, cores, memory, operating system: a JSON object as text.
std::string machine();

/// Versions of the libraries that the numbers pass through, as a JSON object too. BLAS is asked at
/// run time, because which one is used is decided when the program is loaded; "unknown" if it is
/// not OpenBLAS.
std::string libraries();

}  // namespace crawford
