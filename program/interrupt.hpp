/// Ctrl-C and SIGTERM, asked for by who wants to end in good order.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace crawford {

/// As long as it lives the first signal is only noted; a second one kills. One at a time.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// The signal that came, or 0.
    int signal() const;

private:
    struct sigaction old_interrupt_ {};
    struct sigaction old_terminate_ {};
};

/// The exit code of a program that a signal has ended: 130 for Ctrl-C, 143 for SIGTERM.
int exit_code_of(int signal);

/// As it has to be typed into a shell.
std::string typed(const std::vector<std::string>& command);

}  // namespace crawford
