#include "program/narrator.hpp"

#include <iostream>

#include "base/terminal.hpp"

namespace crawford {

namespace {

constexpr auto erase_line = "\033[K";

}  // namespace

Narrator::Narrator(bool quiet) : quiet_(quiet), terminal_(stderr_is_terminal()) {}

void Narrator::say(const std::string& line) {
    if (quiet_) return;
    const std::scoped_lock lock(mutex_);
    std::cerr << (terminal_ ? erase_line : "") << line << '\n';
}

void Narrator::glance(const std::string& line) {
    if (quiet_ || !terminal_) return;
    const std::scoped_lock lock(mutex_);
    std::cerr << erase_line << line.substr(0, 79) << '\r' << std::flush;
}

void Narrator::wipe() {
    if (quiet_ || !terminal_) return;
    const std::scoped_lock lock(mutex_);
    std::cerr << erase_line << std::flush;
}

}  // namespace crawford
