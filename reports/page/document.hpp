/// The frame of a page.
#pragma once

#include <string>

#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// A whole page that carries its style with it: no script and no font from outside. Light or dark
/// as the reader's screen is, and readable on paper.
std::string document(const std::string& title, const Html& body);

}  // namespace crawford::reports::page
