/// Keys as TOML writes them: in quotes where they are more than letters, digits, _ and -.
#pragma once

#include <string>
#include <string_view>

namespace crawford {

/// `"filled binder"`, with its quotes; AP.
std::string toml_key(std::string_view key);

/// Takes the first key off a dotted path, without its quotes: of `materials."filled binder".density`
/// first materials, then filled binder, then density.
std::string take_key(std::string_view& path);

}  // namespace crawford
