#include "reference/require.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace crawford::reference {

void require_finite(std::string_view name, double value) {
    if (std::isnan(value)) throw std::invalid_argument(fmt::format("{} is missing", name));
    if (std::isinf(value)) throw std::invalid_argument(fmt::format("{} must be finite", name));
}

void require_positive(std::string_view name, double value) {
    require_finite(name, value);
    if (value <= 0.0) {
        throw std::invalid_argument(fmt::format("{} = {} must be positive", name, value));
    }
}

void require_not_negative(std::string_view name, double value) {
    require_finite(name, value);
    if (value < 0.0) {
        throw std::invalid_argument(fmt::format("{} = {} must not be negative", name, value));
    }
}

}  // namespace crawford::reference
