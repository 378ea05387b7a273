/// Short numbers for long texts.
#pragma once

#include <string>
#include <string_view>

namespace crawford {

/// SHA-1 of a text, as hexadecimal digits in groups: the same in every run and on every machine.
std::string digest(std::string_view text);

}  // namespace crawford
