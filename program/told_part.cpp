#include "program/told_part.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "base/errors.hpp"

namespace crawford {

double told_part(const std::string& option, const std::string& text, const std::string& of) {
    std::string_view number = text;
    const bool is_percent = number.ends_with('%');
    if (is_percent) number.remove_suffix(1);
    while (number.ends_with(' ')) number.remove_suffix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size() || !(value > 0.0) ||
        !std::isfinite(value))
        throw InputError(
            fmt::format("{} = {}; give {} above 0, as \"1 %\" or 0.01", option, text, of));
    return is_percent ? value / 100.0 : value;
}

}  // namespace crawford
