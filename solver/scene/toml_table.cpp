#include "solver/scene/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "solver/scene/toml_key.hpp"
#include "solver/scene/units.hpp"

namespace crawford {

namespace {

/// "FILE:LINE"; what has no line did not come from the file.
std::string location(const toml::node* node, const std::string& fallback) {
    if (node == nullptr) return fallback;
    if (!node->source().path) return "--set";
    return fmt::format("{}:{}", *node->source().path, node->source().begin.line);
}

std::string one_line(std::string text) {
    const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
    std::replace_if(text.begin(), text.end(), is_control, ' ');
    return text;
}

/// A value as the file has it, on one line and of bounded length.
std::string shown(const toml::node& node) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    node.visit([&text](const auto& value) {
        if constexpr (toml::is_string<decltype(value)>) {
            text << '"' << *value << '"';
        } else {
            text << value;
        }
    });
    const std::string line = one_line(text.str());
    constexpr std::size_t longest = 60;
    return line.size() <= longest ? line : line.substr(0, longest - 3) + "...";
}

}  // namespace

TomlTable::TomlTable(const toml::table* table, std::string path, std::string where)
    : table_(table), path_(std::move(path)), where_(std::move(where)) {}

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::string> keys;
    for (const auto& entry : *table_) keys.emplace_back(entry.first.str());
    return keys;
}

std::string TomlTable::name(std::string_view key) const {
    return one_line(fmt::format("{}: {}{}{}", location(table_->get(key), where_), path_,
                                path_.empty() ? "" : ".", toml_key(key)));
}

void TomlTable::refuse(std::string_view key, std::string_view what) const {
    const toml::node* node = table_->get(key);
    throw InputError(node == nullptr || node->is_table() || node->is_array()
                         ? fmt::format("{} {}", name(key), what)
                         : fmt::format("{} = {} {}", name(key), shown(*node), what));
}

void TomlTable::refuse_type(std::string_view key, std::string_view expected) const {
    refuse(key, fmt::format("has the wrong type; expected {}", expected));
}

const toml::node* TomlTable::find(std::string_view key, Need need) {
    known_.emplace_back(key);
    const toml::node* node = table_->get(key);
    if (node == nullptr && need == Need::required) missing_.emplace_back(key);
    return node;
}

void TomlTable::check_interval(std::string_view key, double value, const Limits& limits) const {
    if (value >= limits.least && value <= limits.most) return;  // false for NaN
    const std::string unit = *limits.unit == '\0' ? "" : fmt::format(" {}", limits.unit);
    refuse(key, fmt::format("is outside the limits; give a value from {0}{2} to {1}{2}",
                            limits.least, limits.most, unit));
}

void TomlTable::quantity(std::string_view key, double& value, const Limits& limits, Need need) {
    const toml::node* node = find(key, need);
    if (node == nullptr) return;
    const auto text = node->value_exact<std::string>();
    if (!text)
        refuse_type(key, fmt::format("a string with a number and a unit in {}", limits.unit));
    double read = 0.0;
    try {
        read = read_quantity(*text, limits.unit);
    } catch (const InputError& error) {
        refuse(key, error.what());
    }
    check_interval(key, read, limits);
    value = read;
}

void TomlTable::quantity(std::string_view key, std::optional<double>& value, const Limits& limits) {
    double read = 0.0;
    quantity(key, read, limits);
    if (has(key)) value = read;
}

void TomlTable::quantity_or(std::string_view word, bool& is_word, std::string_view key,
                            double& value, const Limits& limits) {
    const toml::node* node = table_->get(key);
    is_word = node != nullptr && node->value_exact<std::string>() == word;
    if (is_word)
        allow(key);
    else
        quantity(key, value, limits, Need::required);
}

void TomlTable::number(std::string_view key, double& value, const Limits& limits, Need need) {
    const toml::node* node = find(key, need);
    if (node == nullptr) return;
    if (!node->is_number()) refuse_type(key, "a number without quotes and unit");
    const double read = *node->value<double>();
    check_interval(key, read, limits);
    value = read;
}

void TomlTable::number(std::string_view key, std::optional<double>& value, const Limits& limits) {
    double read = 0.0;
    number(key, read, limits);
    if (has(key)) value = read;
}

void TomlTable::integer(std::string_view key, int& value, const IntegerLimits& limits, Need need) {
    const toml::node* node = find(key, need);
    if (node == nullptr) return;
    const auto read = node->value_exact<std::int64_t>();
    if (!read) refuse_type(key, "a whole number without quotes");
    if (*read < limits.least || *read > limits.most) {
        refuse(key, fmt::format("is outside the limits; give a whole number from {} to {}",
                                limits.least, limits.most));
    }
    value = static_cast<int>(*read);
}

void TomlTable::flag(std::string_view key, bool& value) {
    const toml::node* node = find(key, Need::optional);
    if (node == nullptr) return;
    const auto read = node->value_exact<bool>();
    if (!read) refuse_type(key, "true or false without quotes");
    value = *read;
}

void TomlTable::text(std::string_view key, std::string& value, Need need) {
    const toml::node* node = find(key, need);
    if (node == nullptr) return;
    const auto read = node->value_exact<std::string>();
    if (!read) refuse_type(key, "a string in quotes");
    value = *read;
}

std::optional<std::size_t> TomlTable::index_of(std::string_view key,
                                               const std::vector<std::string>& known, Need need) {
    std::string word;
    text(key, word, need);
    if (!has(key)) return std::nullopt;
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) {
        const std::string nearest = nearest_name(word, known);
        const std::string hint =
            nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
        refuse(key, fmt::format("is none of \"{}\"{}", fmt::join(known, "\", \""), hint));
    }
    return static_cast<std::size_t>(found - known.begin());
}

TomlTable TomlTable::table(std::string_view key) {
    const toml::node* node = find(key, Need::optional);
    if (node != nullptr && !node->is_table()) refuse_type(key, "a table");
    const std::string path =
        path_.empty() ? toml_key(key) : fmt::format("{}.{}", path_, toml_key(key));
    static const toml::table empty;
    return {node == nullptr ? &empty : node->as_table(), path, location(node, where_)};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
    const toml::node* node = find(key, Need::optional);
    std::vector<TomlTable> tables;
    if (node == nullptr) return tables;
    const toml::array* array = node->as_array();
    if (array == nullptr) refuse_type(key, "an array of tables");
    for (const toml::node& element : *array) {
        if (!element.is_table()) refuse_type(key, "an array of tables");
        tables.emplace_back(element.as_table(), fmt::format("{}.{}[{}]", path_, key, tables.size()),
                            location(&element, where_));
    }
    return tables;
}

void TomlTable::finish(std::string_view remark) const {
    for (const auto& [key, node] : *table_) {
        const std::string_view word = key.str();
        if (std::find(known_.begin(), known_.end(), word) == known_.end()) {
            throw InputError(
                fmt::format("{} is not a key of a scene{}", name(word), suggestion(word, known_)));
        }
    }
    if (missing_.empty()) return;
    std::vector<std::string> missing;
    for (const std::string& key : missing_)
        missing.push_back(path_.empty() ? toml_key(key)
                                        : fmt::format("{}.{}", path_, toml_key(key)));
    throw InputError(one_line(fmt::format("{}: {} {} missing{}", location(nullptr, where_),
                                          fmt::join(missing, ", "),
                                          missing.size() == 1 ? "is" : "are", remark)));
}

}  // namespace crawford
