#include "solver/run/timing_table.hpp"

#include <fmt/format.h>

namespace crawford {

std::string timing_table(const std::vector<ModuleTime>& modules, double seconds, long steps) {
    std::string table =
        fmt::format("{:<20} {:>10} {:>8} {:>10}\n", "module", "seconds", "share", "ms/step");
    const auto add = [&](const std::string& name, double spent) {
        table += fmt::format("{:<20} {:>10.3f} {:>6.1f} % {:>10.3f}\n", name, spent,
                             seconds > 0.0 ? 100.0 * spent / seconds : 0.0,
                             steps > 0 ? 1e3 * spent / double(steps) : 0.0);
    };
    double rest = seconds;
    for (const ModuleTime& module : modules) {
        add(module.module, module.seconds);
        rest -= module.seconds;
    }
    add("set-up and output", rest);
    add(fmt::format("all {} steps", steps), seconds);
    return table;
}

}  // namespace crawford
