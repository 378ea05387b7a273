/// The one estimate of uncertainty that is taken where one is needed: by gates and the ledger, and
/// marked by `crawford order`. docs/uncertainty.md says how it was chosen.
#pragma once

#include <span>
#include <string_view>

#include "reports/extrapolate.hpp"

namespace crawford::reports {

/// Its name among estimates(); \see estimate.hpp
inline constexpr std::string_view default_estimate = "roache";

/// Why this one, for a line of text.
inline constexpr std::string_view default_estimate_because =
    "the narrowest that held the truth of 95 % of our own values (docs/uncertainty.md)";

/// The limit and the uncertainty that the default estimate gives.
/// \throws std::invalid_argument as extrapolate()
Extrapolation default_limit(std::span<const double> h, std::span<const double> values,
                            double formal_order);

}  // namespace crawford::reports
