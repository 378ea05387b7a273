#include "program/told_truth.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "reference/truth_materials.hpp"
#include "reports/wrapped.hpp"
#include "solver/scene/units.hpp"

namespace crawford {

namespace {

constexpr std::size_t width = 100;

const reference::Parameter& parameter_named(const reference::TruthEntry& entry,
                                            const std::string& name) {
    const auto found = std::ranges::find(entry.parameters, name, &reference::Parameter::name);
    if (found != entry.parameters.end()) return *found;
    std::vector<std::string> names;
    for (const auto& parameter : entry.parameters) names.push_back(parameter.name);
    throw InputError(
        fmt::format("{}: unknown parameter {}{}", entry.name, name, suggestion(name, names)));
}

/// A number without a unit, as pure numbers are and infinity is.
bool bare_number(const std::string& text, double& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

double number_of(const reference::Parameter& parameter, const std::string& text) {
    double number = 0.0;
    if (bare_number(text, number) && (parameter.unit == "1" || !std::isfinite(number)))
        return number;
    return read_quantity(text, parameter.unit);
}

reference::ParameterValue value_of(const reference::TruthEntry& entry,
                                   const reference::Parameter& parameter, const std::string& text) {
    if (parameter.is_text()) return text;
    try {
        return number_of(parameter, text);
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}: {} = \"{}\" {}", entry.name, parameter.name, text, error.what()));
    }
}

void require_inside(const reference::Truth& truth, const Eigen::Vector2d& point, double time,
                    const std::string& place) {
    try {
        truth.values(std::span(&point, 1), time);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} {}", place, error.what()));
    }
}

/// Of a property: that of either material; who solves the case needs the numbers.
std::string otherwise(const reference::Parameter& parameter) {
    constexpr std::string_view material = "that of ";
    if (!parameter.otherwise.starts_with(material) || !parameter.otherwise.ends_with("material"))
        return parameter.otherwise;
    const auto prefix = parameter.otherwise.substr(material.size());
    const auto name = parameter.name.substr(prefix.size() - std::string_view("material").size());
    return fmt::format("{}: AP {:g}, binder {:g}", parameter.otherwise,
                       reference::property_of(reference::ap(), name),
                       reference::property_of(reference::binder(), name));
}

std::string parameter_text(const reference::Parameter& parameter) {
    const std::string unit =
        parameter.is_text() || parameter.unit == "1" ? "" : fmt::format(" [{}]", parameter.unit);
    return fmt::format("  {}{} = {}\n", parameter.name, unit, standard_of(parameter)) +
           reports::wrapped(fmt::format("{}; {}", parameter.meaning, limits_of(parameter)),
                            "      ", width);
}

}  // namespace

reference::Truth told_truth(const reference::TruthEntry& entry,
                            const std::vector<std::string>& set) {
    reference::Parameters given;
    for (const std::string& one : set) {
        const auto equals = one.find('=');
        if (equals == std::string::npos)
            throw InputError(fmt::format("--set {}: write key=value", one));
        const auto& parameter = parameter_named(entry, one.substr(0, equals));
        given[parameter.name] = value_of(entry, parameter, one.substr(equals + 1));
    }
    return entry.make(given);
}

reference::FieldTable told_values(const reference::Truth& truth, const CsvTable& table,
                                  const std::vector<Eigen::Vector2d>& points, double time) {
    try {
        return truth.values(points, time);
    } catch (const InputError&) {
        truth.values({}, time);  // the time itself
        for (std::size_t k = 0; k < points.size(); ++k)
            require_inside(truth, points[k], time, table.place(table.rows[k].line));
        throw;
    }
}

double told_time(const std::string& time) {
    try {
        return read_quantity(time, "s");
    } catch (const InputError& error) {
        throw InputError(fmt::format("--time \"{}\" {}", time, error.what()));
    }
}

std::string limits_of(const reference::Parameter& parameter) {
    return parameter.is_text() ? fmt::format("one of {}", fmt::join(parameter.choices, ", "))
                               : parameter.limits.wanted(parameter.unit);
}

std::string standard_of(const reference::Parameter& parameter) {
    if (!parameter.standard) return fmt::format("({})", otherwise(parameter));
    if (const auto* text = std::get_if<std::string>(&*parameter.standard)) return *text;
    return fmt::format("{:.12g}", std::get<double>(*parameter.standard));
}

std::string described(const reference::TruthEntry& entry) {
    auto text = entry.name + '\n' + reports::wrapped(entry.description, "  ", width) +
                reports::wrapped("Source: " + entry.source, "  ", width);
    text += "\nParameters (--set key=value, with a unit), and what holds if they are not given:\n";
    for (const auto& parameter : entry.parameters) text += parameter_text(parameter);
    text += "\nFields:\n";
    for (const auto& field : entry.fields)
        text += reports::wrapped(fmt::format("{} [{}]: {}", field.name, field.unit, field.meaning),
                                 "  ", width);
    text += "\nPoints that lie within, to begin with:\n  x [m],y [m]\n";
    for (const auto& point : {entry.examples.front(), entry.examples.back()})
        text += fmt::format("  {:g},{:g}\n", point.x(), point.y());
    if (entry.example_time != 0.0)
        text += fmt::format("at --time \"{:g} s\"\n", entry.example_time);
    return text;
}

}  // namespace crawford
