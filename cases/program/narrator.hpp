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

    /// One line that will soon be out of date: only to a terminal, because in a file it is noise.
    void glance(const std::string& line);

private:
    std::mutex mutex_;
    bool quiet_;
    bool terminal_;
};

}  // namespace crawford
