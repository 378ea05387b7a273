/// What went wrong, as the one line and the exit code that a user gets.
#pragma once

#include <exception>
#include <string>

namespace crawford {

struct Failure {
    std::string message;
    int exit_code;
};

/// What is said where memory is short.
inline constexpr auto out_of_memory = "out of memory; use fewer cells";

Failure failure_of(const std::exception_ptr& problem);

}  // namespace crawford
