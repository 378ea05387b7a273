#include <fmt/format.h>

#include <iostream>
#include <string>

#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/outside_options.hpp"
#include "program/point_file.hpp"
#include "program/told_truth.hpp"

namespace crawford {

namespace {

/// The beginning of a description, on one line of at most 100 columns with the name before it.
std::string beginning(const std::string& text) {
    constexpr std::size_t room = 72;
    std::string sentence = text.substr(0, text.find_first_of(".;"));
    if (sentence.size() <= room) return sentence;
    return sentence.substr(0, sentence.rfind(' ', room - 3)) + " ...";
}

void print_list() {
    for (const auto& entry : reference::truths())
        std::cout << fmt::format("{:<26} {}\n", entry.name, beginning(entry.description));
}

/// What only x and y may stand in.
CsvTable read_points(const std::filesystem::path& file) {
    CsvTable table = read_csv(file);
    for (const std::string& heading : table.header)
        if (const auto name = csv_heading(heading).name; name != "x" && name != "y")
            throw InputError(
                fmt::format("{} has the column \"{}\"; points are a table of \"x [m],y [m]\", in "
                            "any unit of length",
                            table.place(table.header_line), heading));
    return table;
}

void print_csv(const std::vector<Eigen::Vector2d>& points, const reference::FieldTable& found) {
    std::string text = "x [m],y [m]";
    for (const auto& field : found.fields())
        text += fmt::format(",{} [{}]", field.name, field.unit);
    text += '\n';
    for (std::size_t k = 0; k < points.size(); ++k) {
        text += fmt::format("{},{}", points[k].x(), points[k].y());
        for (const double value : found.values().row(static_cast<Eigen::Index>(k)))
            text += fmt::format(",{}", value);
        text += '\n';
    }
    std::cout << text;
}

}  // namespace

int truth(const TruthOptions& options) {
    if (options.list) {
        print_list();
        return exit_code::done;
    }
    if (options.name.empty())
        throw InputError("no truth is named; crawford truth --list shows them");
    const auto& entry = reference::find_truth(options.name);
    if (options.describe) {
        std::cout << described(entry);
        return exit_code::done;
    }
    if (options.points.empty())
        throw InputError(fmt::format(
            "truth {}: --points FILE.csv is missing; --describe shows parameters, fields and "
            "points to begin with",
            entry.name));
    const CsvTable table = read_points(options.points);
    const auto points = csv_points(table);
    const double time = options.time.empty() ? 0.0 : told_time(options.time);
    print_csv(points, told_values(told_truth(entry, options.set), table, points, time));
    return exit_code::done;
}

}  // namespace crawford
