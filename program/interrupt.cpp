#include "program/interrupt.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace crawford {

namespace {

/// A signal handler writes it and other threads read it, so it must be atomic, and without a lock.
std::atomic<int> caught = 0;
static_assert(std::atomic<int>::is_always_lock_free);

std::atomic<bool> is_watched = false;

void note(int signal) {
    caught = signal;
}

}  // namespace

Interrupt::Interrupt() {
    if (is_watched.exchange(true)) throw std::logic_error("signals are watched already");
    caught = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGINT, &action, &old_interrupt_);
    ::sigaction(SIGTERM, &action, &old_terminate_);
}

Interrupt::~Interrupt() {
    ::sigaction(SIGINT, &old_interrupt_, nullptr);
    ::sigaction(SIGTERM, &old_terminate_, nullptr);
    is_watched = false;
}

int Interrupt::signal() const {
    return caught;
}

LeaveOnSignal::LeaveOnSignal(const std::vector<std::string>& command)
    : waiting_([this, again = typed(command)](const std::stop_token& done) {
          constexpr std::chrono::milliseconds glance{50};
          for (; !done.stop_requested(); std::this_thread::sleep_for(glance)) {
              if (interrupt_.signal() == 0) continue;
              std::cerr << "\ncrawford: interrupted; what is done is kept. Go on with: " << again
                        << std::endl;
              std::_Exit(exit_code_of(interrupt_.signal()));
          }
      }) {}

int exit_code_of(int signal) {
    return 128 + signal;
}

std::string typed(const std::vector<std::string>& command) {
    constexpr const char* plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    std::string line;
    for (const std::string& word : command) {
        if (!line.empty()) line += ' ';
        if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

}  // namespace crawford
