/// What is said to who watches.
#pragma once

#include <string>

namespace crawford {

/// "h:mm:ss" or, below an hour, "m:ss".
std::string clock_time(double seconds);

/// Whether stderr is a terminal: into a file or a pipe, progress is noise.
bool stderr_is_terminal();

}  // namespace crawford
