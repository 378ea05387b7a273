/// A part of something, as it is typed.
#pragma once

#include <string>

namespace crawford {

/// 0.01 of "1 %" and of "0.01".
/// \param of what, for the message: "a part of V"
/// \throws InputError naming the option if it is no finite number above 0
double told_part(const std::string& option, const std::string& text, const std::string& of);

}  // namespace crawford
