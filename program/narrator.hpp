/// What goes on, told on stderr: line by line, from any thread.
#pragma once

#include <mutex>
#include <string>

namespace crawford {

class Narrator {
public:
    explicit Narrator(bool quiet);

    /// One line, unless quiet.
    void say(const std::string& line);

    /// A line that will soon be out of date, and that whatever comes next is written over: only to
    /// a terminal, because in a file it is noise.
    void glance(const std::string& line);

    /// Wipes that line away; for who writes to stdout.
    void wipe();

private:
    std::mutex mutex_;
    bool quiet_;
    bool terminal_;
};

}  // namespace crawford
