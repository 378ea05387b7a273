#include <fmt/format.h>

#include <iostream>
#include <sstream>

#include "program/commands.hpp"

namespace crawford {

namespace {

constexpr size_t width_of_text = 52;
constexpr auto row = "{:<20} {:<8} {:<52} {:>16}\n";  // 99 columns

std::string duration(double seconds) {
    return seconds < 100.0 ? fmt::format("{:.0f} s", seconds)
                           : fmt::format("{:.0f} min", seconds / 60.0);
}

std::string cost(const Entry& entry) {
    if (!entry.draw) return duration(entry.cost.verify);
    return duration(entry.cost.draft) + " / " + duration(entry.cost.paper);
}

/// The words of `text` in lines of at most width_of_text.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width_of_text)
            lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

void print(const Entry& entry) {
    const auto lines = lines_of(entry.shows);
    std::cout << fmt::format(row, entry.name, entry.figure, lines.front(), cost(entry));
    for (size_t k = 1; k < lines.size(); ++k) std::cout << fmt::format("{:<29} {}\n", "", lines[k]);
}

}  // namespace

int list(const ListOptions& options) {
    if (options.studies) {
        for (const Entry& entry : catalogue())
            if (entry.studies) std::cout << fmt::format("{} {:g}\n", entry.name, entry.cost.verify);
        return exit_code::done;
    }
    std::cout << fmt::format(row, "name", "figure", "shows", "cost");
    for (const Entry& entry : catalogue()) print(entry);
    std::cout << "\nWith a figure: crawford run NAME, cost as draft / as in the paper. Without: a "
                 "study, crawford\nverify NAME. Costs are wall times on two cores.\n";
    return exit_code::done;
}

}  // namespace crawford
