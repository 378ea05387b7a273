#include "solver/scene/toml_key.hpp"

#include <algorithm>
#include <cctype>

namespace crawford {

namespace {

bool is_bare(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

}  // namespace

std::string toml_key(std::string_view key) {
    if (!key.empty() && std::ranges::all_of(key, is_bare)) return std::string(key);
    std::string quoted = "\"";
    for (const char c : key) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
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
