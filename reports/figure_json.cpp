#include "reports/figure_json.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/whole_number.hpp"

namespace crawford::reports {

namespace {

using Json = nlohmann::ordered_json;

template <class Word, size_t n>
Word named(const std::string& word, const Word (&all)[n]) {
    for (const Word one : all)
        if (name(one) == word) return one;
    throw std::invalid_argument(word + " is unknown in a figure");
}

Format format_named(const std::string& word) {
    return named(word, {Format::svg, Format::png, Format::gif});
}

Table::Kind kind_named(const std::string& word) {
    using Kind = Table::Kind;
    return named(word, {Kind::columns, Kind::corner_map, Kind::cell_map, Kind::other});
}

/// A number that is not finite becomes null: gnuplot knows one such number only, NaN.
Json variable(const std::variant<double, std::string>& value) {
    if (const auto* const text = std::get_if<std::string>(&value)) return *text;
    const double number = std::get<double>(value);
    return std::isfinite(number) ? Json(number) : Json();
}

std::variant<double, std::string> variable(const Json& json) {
    if (json.is_string()) return json.get<std::string>();
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

}  // namespace

void to_json(Json& json, const FigureContents& contents) {
    json = {{"name", contents.name},
            {"script", contents.script.generic_string()},
            {"caption", contents.caption},
            {"keeps_numbers", contents.keeps_numbers}};
    auto& tables = json["tables"] = Json::array();
    for (const Table& table : contents.tables)
        if (table.file.is_relative())
            tables.push_back({{"name", table.name},
                              {"kind", name(table.kind)},
                              {"file", table.file.generic_string()}});
    auto& variables = json["variables"] = Json::object();
    for (const auto& [name, value] : contents.variables) variables[name] = variable(value);
    auto& panels = json["panels"] = Json::array();
    for (const Panel& panel : contents.panels)
        panels.push_back({{"name", panel.name},
                          {"format", name(panel.format)},
                          {"width", panel.size.width},
                          {"height", panel.size.height}});
}

void from_json(const Json& json, FigureContents& contents) {
    json.at("name").get_to(contents.name);
    contents.script = json.at("script").get<std::string>();
    json.at("caption").get_to(contents.caption);
    json.at("keeps_numbers").get_to(contents.keeps_numbers);
    for (const auto& table : json.at("tables"))
        contents.tables.push_back(
            {table.at("name"), kind_named(table.at("kind")), table.at("file").get<std::string>()});
    for (const auto& [name, value] : json.at("variables").items())
        contents.variables[name] = variable(value);
    for (const auto& panel : json.at("panels"))
        contents.panels.push_back(
            {panel.at("name"),
             format_named(panel.at("format")),
             {whole_number<int>(panel.at("width")), whole_number<int>(panel.at("height"))}});
}

}  // namespace crawford::reports
