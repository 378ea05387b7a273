/// What goes on, told on stderr: line by line, from any thread.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace crawford {

class Narrator {
public:
    explicit Narrator(bool quiet);

    /// One line, unless quiet.
    void say(const std::string& line);

    /// How much of a long run is done (0 to 1) and how long it will take at its pace so far; every
    /// few seconds, and only to a terminal, because in a file it is noise.
    void progress(const std::string& what, double done);

private:
    using Clock = std::chrono::steady_clock;

    struct Course {
        Clock::time_point started;
        Clock::time_point last_told;
    };

    std::mutex mutex_;
    bool quiet_;
    bool terminal_;
    std::map<std::string, Course> courses_;
};

}  // namespace crawford
