/// Parameters that are missing or out of range, refused by name.
#pragma once

#include <string_view>

namespace crawford::reference {

/// \throws std::invalid_argument naming the parameter, if it is missing (NaN) or infinite.
void require_finite(std::string_view name, double value);

/// \throws std::invalid_argument naming the parameter, its value and the limit, unless it is finite
/// and > 0.
void require_positive(std::string_view name, double value);

/// \throws std::invalid_argument naming the parameter, its value and the limit, unless it is finite
/// and >= 0.
void require_not_negative(std::string_view name, double value);

}  // namespace crawford::reference
