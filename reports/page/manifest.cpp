#include "reports/page/manifest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

using Json = nlohmann::ordered_json;

std::string spoken(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_structured()) return value.dump();
    std::string text;
    for (const auto& [key, part] : value.items()) {
        const auto separator = value.is_array() ? " " : ", ";
        text +=
            (text.empty() ? "" : separator) + (value.is_array() ? "" : key + " ") + spoken(part);
    }
    return text;
}

/// A member as text; empty if it is not there.
std::string member(const Json& object, const char* key) {
    const auto at = object.find(key);
    return at == object.end() ? std::string() : spoken(*at);
}

}  // namespace

Html circumstances(const std::string& text) {
    const auto members = Json::parse(text);
    std::vector<std::string> facts{"revision " + member(members, "revision")};
    if (members.contains("fidelity")) facts.push_back("fidelity " + member(members, "fidelity"));
    if (const auto seconds = members.find("wall_seconds"); seconds != members.end())
        facts.push_back(seconds->is_number() ? duration(seconds->get<double>()) : spoken(*seconds));
    if (members.contains("machine")) {
        const auto& machine = members.at("machine");
        facts.push_back(
            fmt::format("{} cores, {}", member(machine, "cores"), member(machine, "processor")));
    }
    if (members.contains("ended")) facts.push_back(member(members, "ended"));
    return styled("p", "facts", fmt::format("{}", fmt::join(facts, " \u00b7 ")));
}

Html manifest(const std::string& text) {
    const auto members = Json::parse(text);
    Html rows;
    for (const auto& [key, value] : members.items())
        rows += element("tr", {}, element("th", {}, key) + element("td", {}, spoken(value))) + "\n";
    return element(
               "section", {{"id", "manifest"}},
               element("h2", {}, "Manifest") + element("table", {{"class", "manifest"}}, rows)) +
           "\n";
}

}  // namespace crawford::reports::page
