/// The opening comment of a study, which is its page for a reader.
#pragma once

#include <string>
#include <string_view>

#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// The text of the `///` lines that a source file begins with, without the slashes.
std::string opening_comment(std::string_view source);

/// Markdown as those comments use it: a heading "# ..." (the element `heading`), paragraphs, lists
/// of lines that begin with
/// "- ", blocks indented by four, `code`.
Html prose(std::string_view markdown, std::string_view heading = "h2");

}  // namespace crawford::reports::page
