#include "reports/page/manifest.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace

Html manifest(const Json& members) {
    Html rows;
    for (const auto& [key, value] : members.items())
        rows += element("tr", {}, element("th", {}, key) + element("td", {}, spoken(value))) + "\n";
    return element(
               "section", {{"id", "manifest"}},
               element("h2", {}, "Manifest") + element("table", {{"class", "manifest"}}, rows)) +
           "\n";
}

}  // namespace crawford::reports::page
