#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// When, on what and from which sources, in a line: what of it the manifest says.
Html circumstances(const nlohmann::ordered_json& members);

/// What the results were computed with and on, member by member.
Html manifest(const nlohmann::ordered_json& members);

}  // namespace crawford::reports::page
