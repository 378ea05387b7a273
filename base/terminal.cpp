#include "base/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace crawford {

std::string clock_time(double seconds) {
    const long whole = std::lround(seconds);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

bool stderr_is_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace crawford
