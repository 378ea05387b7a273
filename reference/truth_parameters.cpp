#include "reference/truth_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"

namespace crawford::reference {

namespace {

std::string with_unit(double value, const std::string& unit) {
    return unit == "1" ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

const Parameter& parameter_named(const std::vector<Parameter>& known, const std::string& name) {
    const auto found = std::ranges::find(known, name, &Parameter::name);
    if (found != known.end()) return *found;
    std::vector<std::string> names;
    for (const Parameter& parameter : known) names.push_back(parameter.name);
    throw InputError(fmt::format("unknown parameter {}{}", name, suggestion(name, names)));
}

void require_choice(const Parameter& parameter, const ParameterValue& value) {
    const auto* chosen = std::get_if<std::string>(&value);
    if (!chosen)
        throw InputError(fmt::format("{} = {} must be a text{}", parameter.name,
                                     std::get<double>(value), suggestion("", parameter.choices)));
    if (std::ranges::find(parameter.choices, *chosen) == parameter.choices.end())
        throw InputError(fmt::format("{} = {} is unknown{}", parameter.name, *chosen,
                                     suggestion(*chosen, parameter.choices)));
}

void require_number(const Parameter& parameter, const ParameterValue& value) {
    const std::string wanted = parameter.limits.wanted(parameter.unit);
    const auto* number = std::get_if<double>(&value);
    if (!number)
        throw InputError(fmt::format("{} = {} must be a number, {}", parameter.name,
                                     std::get<std::string>(value), wanted));
    if (!parameter.limits.contains(*number))
        throw InputError(fmt::format("{} = {} must be {}", parameter.name,
                                     with_unit(*number, parameter.unit), wanted));
}

}  // namespace

bool Limits::contains(double value) const {
    if (std::isnan(value) || (std::isinf(value) && !infinite)) return false;
    if (whole && value != std::round(value)) return false;
    if (value == to && std::isinf(to)) return true;
    return open ? from < value && value < to : from <= value && value <= to;
}

std::string Limits::wanted(const std::string& unit) const {
    const std::string kind = whole ? "a whole number " : "";
    if (std::isinf(from) && std::isinf(to)) return kind + "any finite number";
    if (std::isinf(to)) return kind + (open ? "above " : "at least ") + with_unit(from, unit);
    if (std::isinf(from)) return kind + (open ? "below " : "at most ") + with_unit(to, unit);
    return kind + fmt::format("{} {} {} {}", open ? "between" : "from", from, open ? "and" : "to",
                              with_unit(to, unit));
}

Parameter number(std::string name, std::string unit, double standard, Limits limits,
                 std::string meaning) {
    return {.name = std::move(name),
            .unit = std::move(unit),
            .meaning = std::move(meaning),
            .standard = standard,
            .limits = limits};
}

Parameter text(std::string name, std::string standard, std::vector<std::string> choices,
               std::string meaning) {
    return {.name = std::move(name),
            .unit = "",
            .meaning = std::move(meaning),
            .standard = std::move(standard),
            .choices = std::move(choices)};
}

Given::Given(const std::vector<Parameter>& known, const Parameters& given) : values_(given) {
    for (const auto& [name, value] : given) {
        const Parameter& parameter = parameter_named(known, name);
        if (parameter.is_text()) {
            require_choice(parameter, value);
        } else {
            require_number(parameter, value);
        }
    }
    for (const Parameter& parameter : known)
        if (parameter.standard) values_.try_emplace(parameter.name, *parameter.standard);
}

double Given::number(const std::string& name) const {
    return std::get<double>(values_.at(name));
}

const std::string& Given::text(const std::string& name) const {
    return std::get<std::string>(values_.at(name));
}

double Given::number_or(const std::string& name, double otherwise) const {
    const auto found = values_.find(name);
    return found == values_.end() ? otherwise : std::get<double>(found->second);
}

}  // namespace crawford::reference
