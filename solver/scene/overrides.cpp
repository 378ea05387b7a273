#include "solver/scene/overrides.hpp"

#include <fmt/format.h>

#include <string>

#include "base/errors.hpp"
#include "solver/scene/toml_key.hpp"

namespace crawford {

namespace {

toml::table parse_value(std::string_view text) {
    try {
        toml::table parsed = toml::parse(fmt::format("value = {}", text));
        if (parsed.size() == 1) return parsed;
    } catch (const toml::parse_error&) {
        // Not TOML: a bare word or a quantity, taken as a string below.
    }
    return toml::table{{"value", std::string(text)}};
}

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

}  // namespace

void apply_override(toml::table& scene, std::string_view assignment) {
    const auto equals = assignment.find('=');
    std::string_view path = trimmed(assignment.substr(0, equals));
    if (equals == std::string_view::npos || path.empty()) {
        throw InputError(fmt::format(
            "--set \"{}\" is no assignment; write key=value, for example surface.pressure=3 MPa",
            assignment));
    }
    toml::table* table = &scene;
    std::string key = take_key(path);
    for (; !path.empty(); key = take_key(path)) {
        toml::node& next = table->insert(key, toml::table{}).first->second;
        if (!next.is_table()) {
            throw InputError(fmt::format("--set \"{}\" runs through {}, which is no table",
                                         assignment, toml_key(key)));
        }
        table = next.as_table();
    }
    const std::string_view text = trimmed(assignment.substr(equals + 1));
    if (text.empty()) {
        if (table->erase(key) == 0) {
            throw InputError(fmt::format(
                "--set \"{}\" removes a key that the scene does not give; check its name",
                assignment));
        }
        return;
    }
    const toml::table value = parse_value(text);
    table->insert_or_assign(key, *value.get("value"));  // a copy, which has no line
}

}  // namespace crawford
