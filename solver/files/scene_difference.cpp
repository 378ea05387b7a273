#include "solver/files/scene_difference.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/errors.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

using Values = std::map<std::string, std::string>;

std::string printed(const toml::node& node) {
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

void flatten(const toml::node& node, const std::string& path, Values& values) {
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : *table)
            flatten(value,
                    path.empty() ? std::string(key.str()) : path + '.' + std::string(key.str()),
                    values);
    } else if (const toml::array* array = node.as_array()) {
        for (size_t k = 0; k < array->size(); ++k)
            flatten((*array)[k], fmt::format("{}[{}]", path, k), values);
    } else {
        values[path] = printed(node);
    }
}

Values parse(const std::string& scene) {
    Values values;
    try {
        flatten(toml::parse(scene), "", values);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("a scene that is no TOML: {}", error.description()));
    }
    std::erase_if(values, [](const auto& item) {
        const std::string& key = item.first;
        return key == "title" || key == "time.end" || key == "time.step" ||
               key == "time.accuracy" || key == "time.until_steady" || key == "morphology.source" ||
               key.starts_with("output.");
    });
    return values;
}

/// With the defaults that an earlier program left out of its checkpoints. What is no whole scene is
/// compared as it stands.
std::string complete(const std::string& scene) {
    try {
        return to_toml(parse_scene(scene));
    } catch (const InputError&) {
        return scene;
    }
}

std::string value_of(const Values& values, const std::string& key) {
    const auto found = values.find(key);
    return found == values.end() ? "not given" : found->second;
}

/// The number of a printed value such as "'2e-05 s'", and what stands behind it.
std::optional<std::pair<double, std::string>> quantity(std::string_view printed) {
    while (printed.starts_with('\'') || printed.starts_with('"')) printed.remove_prefix(1);
    double number = 0.0;
    const char* const end = printed.data() + printed.size();
    const auto [after, error] = std::from_chars(printed.data(), end, number);
    if (error != std::errc()) return {};
    return std::pair{number, std::string(after, end)};
}

/// "0.02 ms" and "20 us" are the same, though not to the last bit once they are in seconds.
bool are_equal(const std::string& a, const std::string& b) {
    if (a == b) return true;
    const auto x = quantity(a);
    const auto y = quantity(b);
    if (!x || !y || x->second != y->second) return false;
    // A few roundings of a conversion; nobody writes so many digits to mean another value.
    constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
    return std::abs(x->first - y->first) <=
           rounding * std::max(std::abs(x->first), std::abs(y->first));
}

}  // namespace

std::optional<std::string> difference(const std::string& before, const std::string& scene,
                                      std::string_view where) {
    const Values old_values = parse(complete(before));
    const Values new_values = parse(complete(scene));
    Values all = old_values;
    all.insert(new_values.begin(), new_values.end());
    for (const auto& [key, _] : all) {
        const std::string old_value = value_of(old_values, key);
        const std::string new_value = value_of(new_values, key);
        if (!are_equal(old_value, new_value))
            return fmt::format("{} is {} {} and {} in the scene", key, old_value, where, new_value);
    }
    return std::nullopt;
}

}  // namespace crawford
