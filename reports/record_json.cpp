#include "reports/record_json.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/whole_number.hpp"
#include "reports/failure_json.hpp"
#include "reports/figure_json.hpp"

namespace crawford::reports {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    if (std::isfinite(value)) return value;
    if (std::isnan(value)) return "nan";
    return value > 0.0 ? "inf" : "-inf";
}

double number(const Json& json) {
    if (json.is_number()) return json.get<double>();
    const auto word = json.get<std::string>();
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (word == "inf") return std::numeric_limits<double>::infinity();
    if (word == "-inf") return -std::numeric_limits<double>::infinity();
    throw std::invalid_argument(word + " is no number");
}

Json numbers(const std::vector<double>& values) {
    Json json = Json::array();
    for (const double value : values) json.push_back(number(value));
    return json;
}

std::vector<double> numbers(const Json& json) {
    std::vector<double> values;
    for (const auto& value : json) values.push_back(number(value));
    return values;
}

Json one(const std::string& name, const Amount& value) {
    Json json = {{"name", name}, {"value", number(value.value)}};
    if (!value.unit.empty()) json["unit"] = value.unit;
    return json;
}

Json quantities(const Measurement& found) {
    Json json = Json::array();
    for (const auto& [key, error] : found.errors())
        json.push_back({{"name", key.first},
                        {"norm", name(key.second)},
                        {"error", number(error.error)},
                        {"scale", number(error.scale)}});
    for (const auto& [name, value] : found.values()) json.push_back(one(name, value));
    for (const auto& [name, sample] : found.samples())
        json.push_back({{"name", name},
                        {"sample", numbers(sample.values)},
                        {"weights", numbers(sample.weights)}});
    return json;
}

void read_quantity(const Json& json, Measurement& found) {
    const auto name = json.at("name").get<std::string>();
    if (json.contains("error"))
        found.error(name, norm_named(json.at("norm").get<std::string>()), number(json.at("error")),
                    number(json.at("scale")));
    else if (json.contains("value"))
        found.value(name, Amount{number(json.at("value")), json.value("unit", std::string())});
    else
        found.sample(name, {numbers(json.at("sample")), numbers(json.at("weights"))});
}

Ending::Kind ending_named(const std::string& word) {
    for (const auto kind : {Ending::Kind::done, Ending::Kind::refused, Ending::Kind::failed})
        if (name(kind) == word) return kind;
    throw std::invalid_argument(word + " is no outcome");
}

long count_in(const Json& cost, const char* name) {
    return cost.contains(name) ? whole_number<long>(cost.at(name)) : 0;
}

Json failure(const Ending& ending) {
    Json json = {{"message", ending.message}};
    if (ending.failure) json.update(Json(*ending.failure));
    return json;
}

void read_failure(const Json& json, Ending& ending) {
    json.at("message").get_to(ending.message);
    if (json.contains("kind")) ending.failure = json.get<FailureFields>();
}

}  // namespace

void to_json(Json& json, const Setting& setting) {
    json = Json::object();
    for (const auto& [axis, value] : setting.axes()) {
        if (const auto* const quantity = std::get_if<Amount>(&value))
            json[axis] = {{"value", number(quantity->value)}, {"unit", quantity->unit}};
        else if (const auto* const count = std::get_if<long>(&value))
            json[axis] = *count;
        else
            json[axis] = std::get<std::string>(value);
    }
}

void from_json(const Json& json, Setting& setting) {
    for (const auto& [axis, value] : json.items()) {
        if (value.is_object())
            setting.set(axis, Amount{number(value.at("value")), value.at("unit")});
        else if (value.is_number_integer())
            setting.set(axis, whole_number<long>(value));
        else
            setting.set(axis, value.get<std::string>());
    }
}

void to_json(Json& json, const Record& record) {
    json = {{"experiment", record.experiment}, {"setting", record.setting}};
    if (record.found && !std::isnan(record.found->h())) json["h"] = number(record.found->h());
    json["quantities"] = record.found ? quantities(*record.found) : Json::array();
    json["cost"] = {{"wall_seconds", record.cost.wall_seconds},
                    {"cpu_seconds", record.cost.cpu_seconds},
                    {"peak_memory_bytes", record.cost.peak_memory_bytes}};
    if (const WorkDone& work = record.cost.work; work.steps > 0) {
        json["cost"]["steps"] = work.steps;
        json["cost"]["cells"] = work.cells;
        json["cost"]["solver_iterations"] = work.solver_iterations;
    }
    json["outcome"] = name(record.ending.kind);
    if (!record.ending.is_done()) json["failure"] = failure(record.ending);
    json["fingerprint"] = record.fingerprint;
    if (!record.scenes.empty()) json["scenes"] = record.scenes;
    if (record.figure) json["figure"] = *record.figure;
    if (!record.said.empty()) json["said"] = record.said;
}

void from_json(const Json& json, Record& record) {
    json.at("experiment").get_to(record.experiment);
    json.at("setting").get_to(record.setting);
    json.at("fingerprint").get_to(record.fingerprint);
    const auto& cost = json.at("cost");
    record.cost = {cost.at("wall_seconds"),
                   cost.at("cpu_seconds"),
                   whole_number<long>(cost.at("peak_memory_bytes")),
                   {.steps = count_in(cost, "steps"),
                    .cells = count_in(cost, "cells"),
                    .solver_iterations = count_in(cost, "solver_iterations")}};
    record.ending.kind = ending_named(json.at("outcome"));
    if (!record.ending.is_done()) {
        read_failure(json.at("failure"), record.ending);
        return;
    }
    record.found = json.contains("h") ? Measurement(number(json.at("h"))) : Measurement();
    for (const auto& quantity : json.at("quantities")) read_quantity(quantity, *record.found);
    if (json.contains("scenes")) json.at("scenes").get_to(record.scenes);
    if (json.contains("figure")) record.figure = json.at("figure").get<FigureContents>();
    record.said = json.value("said", std::string());
}

}  // namespace crawford::reports
