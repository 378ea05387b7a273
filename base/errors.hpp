/// What can go wrong, by name.
/// The program turns InputError into exit code 2 and NumericalFailure into 3.
#pragma once

#include <stdexcept>
#include <string>

namespace crawford {

/// The input is wrong.
/// The message is one line that names the key, the value, the limit and what to do.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The numbers failed: a NaN, no convergence, a step beyond its limit. The message is one line that
/// names the room, the cell or node and the numbers; the simulation adds the step.
struct NumericalFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace crawford
