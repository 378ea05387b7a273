/// Numbers and their limits as JSON: in manifests, and on stdout for programs.
#pragma once

#include <string>

#include "solver/guards/guard.hpp"

namespace crawford {

/// NAME -> { "value": V, "limit": L }; what is not finite or has no limit is null.
std::string to_json(const Guards& guards);

/// A list of { name, value, limit, text }; each name once, as it was met where both have it.
std::string remarks_to_json(const Guards& predicted, const Guards& met);

}  // namespace crawford
