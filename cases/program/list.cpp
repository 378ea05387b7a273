#include <fmt/format.h>

#include <iostream>

#include "cases/program/commands.hpp"

namespace crawford {

namespace {

std::string duration(double seconds) {
    return seconds < 60.0 ? fmt::format("{:.0f} s", seconds)
                          : fmt::format("{:.0f} min", seconds / 60.0);
}

std::string cost(const Entry& entry) {
    if (!entry.draw) return duration(entry.cost.verify);
    return duration(entry.cost.draft) + " / " + duration(entry.cost.paper);
}

}  // namespace

int list() {
    constexpr auto row = "{:<20} {:<9} {:<54} {:>14}\n";
    std::cout << fmt::format(row, "name", "figure", "shows", "draft / paper");
    for (const Entry& entry : catalogue())
        std::cout << fmt::format(row, entry.name, entry.figure, entry.shows, cost(entry));
    std::cout << "\nDraw with crawford run NAME; names without a figure are studies: crawford "
                 "verify NAME.\n";
    return exit_code::done;
}

}  // namespace crawford
