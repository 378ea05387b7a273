/// What a result was computed on and with, as far as the system tells.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace crawford {

/// Processor, cores, memory, operating system.
nlohmann::ordered_json machine();

/// Versions of the libraries that the numbers pass through. BLAS is asked at run time, because
/// which one is used is decided when the program is loaded; "unknown" if it is not OpenBLAS.
nlohmann::ordered_json libraries();

/// Largest memory this process has held so far [bytes].
long peak_memory();

}  // namespace crawford
