/// Seconds spent in each room of a step.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace crawford {

struct RoomTime {
    std::string room;
    double seconds;
};

class Stopwatch {
public:
    /// Runs `work` and books its time under `room`.
    template <class Work>
    auto measure(const std::string& room, const Work& work) {
        const Booking booking(entry(room));
        return work();
    }

    const std::vector<RoomTime>& rooms() const { return rooms_; }

private:
    using Clock = std::chrono::steady_clock;

    struct Booking {
        explicit Booking(double& seconds) : total(seconds), start(Clock::now()) {}
        ~Booking() { total += std::chrono::duration<double>(Clock::now() - start).count(); }
        Booking(const Booking&) = delete;
        Booking& operator=(const Booking&) = delete;

        double& total;
        Clock::time_point start;
    };

    double& entry(const std::string& room) {
        for (RoomTime& known : rooms_)
            if (known.room == room) return known.seconds;
        return rooms_.emplace_back(RoomTime{room, 0.0}).seconds;
    }

    std::vector<RoomTime> rooms_;
};

}  // namespace crawford
