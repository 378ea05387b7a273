/// Ctrl-C and SIGTERM, asked for by who wants to end in good order.
#pragma once

#include <csignal>
#include <string>
#include <thread>
#include <vector>

namespace crawford {

/// As long as it lives a signal is only noted.
class Interrupt {
public:
    /// \throws std::logic_error if another lives: it would forget a signal that the other has noted.
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

/// As long as it lives a signal ends the program at once, with a word on stderr: for commands whose
/// results are each whole on the disk as soon as they are found, so that the same command goes on.
class LeaveOnSignal {
public:
    explicit LeaveOnSignal(const std::vector<std::string>& command);
    LeaveOnSignal(const LeaveOnSignal&) = delete;
    LeaveOnSignal& operator=(const LeaveOnSignal&) = delete;

private:
    Interrupt interrupt_;
    std::jthread waiting_;  ///< last: it asks the other
};

/// The exit code of a program that a signal has ended: 130 for Ctrl-C, 143 for SIGTERM.
int exit_code_of(int signal);

/// As it has to be typed into a shell.
std::string typed(const std::vector<std::string>& command);

}  // namespace crawford
