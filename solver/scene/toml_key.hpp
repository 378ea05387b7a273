/// Keys and texts as TOML writes them: a key in quotes where it is more than letters, digits, _ and -.
#pragma once

#include <string>
#include <string_view>

namespace crawford {

/// A text with its quotes, and what may not stand between them escaped.
std::string in_quotes(std::string_view text);

/// `"filled binder"`, with its quotes; AP.
std::string toml_key(std::string_view key);

/// Takes the first key off a dotted path, without its quotes: of `materials."filled binder".density`
/// first materials, then filled binder, then density.
std::string take_key(std::string_view& path);

}  // namespace crawford
