#include "solver/scene/toml_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace crawford {

namespace {

bool is_bare(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

}  // namespace

std::string in_quotes(std::string_view text) {
    std::string in_quotes = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            in_quotes += '\\';
            in_quotes += c;
        } else if (byte < 0x20 || byte == 0x7f) {
            in_quotes += fmt::format("\\u{:04x}", byte);
        } else {
            in_quotes += c;
        }
    }
    return in_quotes + '"';
}

std::string toml_key(std::string_view key) {
    if (!key.empty() && std::ranges::all_of(key, is_bare)) return std::string(key);
    return in_quotes(key);
}

std::string take_key(std::string_view& path) {
    std::string key;
    const bool quoted = path.starts_with('"') && path.find('"', 1) != std::string_view::npos;
    if (quoted) {
        const auto end = path.find('"', 1);
        key = path.substr(1, end - 1);
        path.remove_prefix(end + 1);
    }
    const auto dot = std::min(path.find('.'), path.size());
    key += path.substr(0, dot);
    path.remove_prefix(std::min(dot + 1, path.size()));
    return key;
}

}  // namespace crawford
