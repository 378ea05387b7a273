/// Text broken at a width.
#pragma once

#include <cstddef>
#include <string>

namespace crawford::reports {

/// `text` broken at spaces so that no line exceeds `width` columns (longer words are cut); every
/// line begins with `indent`.
std::string wrapped(const std::string& text, const std::string& indent, std::size_t width);

}  // namespace crawford::reports
