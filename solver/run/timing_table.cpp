#include "solver/run/timing_table.hpp"

#include <fmt/format.h>

namespace crawford {

std::string timing_table(const std::vector<RoomTime>& rooms, double seconds, long steps) {
    std::string table =
        fmt::format("{:<20} {:>10} {:>8} {:>10}\n", "room", "seconds", "share", "ms/step");
    const auto add = [&](const std::string& name, double spent) {
        table += fmt::format("{:<20} {:>10.3f} {:>6.1f} % {:>10.3f}\n", name, spent,
                             seconds > 0.0 ? 100.0 * spent / seconds : 0.0,
                             steps > 0 ? 1e3 * spent / double(steps) : 0.0);
    };
    double rest = seconds;
    for (const RoomTime& room : rooms) {
        add(room.room, room.seconds);
        rest -= room.seconds;
    }
    add("set-up and output", rest);
    add(fmt::format("all {} steps", steps), seconds);
    return table;
}

}  // namespace crawford
