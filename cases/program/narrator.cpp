#include "cases/program/narrator.hpp"

#include <iostream>

#include "solver/output/progress.hpp"

namespace crawford {

Narrator::Narrator(bool quiet) : quiet_(quiet), terminal_(stderr_is_terminal()) {}

void Narrator::say(const std::string& line) {
    if (quiet_) return;
    const std::scoped_lock lock(mutex_);
    std::cerr << line << '\n';
}

void Narrator::glance(const std::string& line) {
    if (terminal_) say(line);
}

}  // namespace crawford
