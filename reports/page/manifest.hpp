/// Of a manifest: a JSON object as text.
#pragma once

#include <string>

#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// When, on what and from which sources, in a line: what of it the manifest says.
Html circumstances(const std::string& text);

/// What the results were computed with and on, member by member.
Html manifest(const std::string& text);

}  // namespace crawford::reports::page
