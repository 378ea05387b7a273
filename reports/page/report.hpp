#pragma once

#include <string>

#include "reports/verification.hpp"

namespace crawford::reports::page {

/// The whole report as one page that needs no other file: no script, no picture, no font from
/// outside. Light or dark as the reader's screen is, and readable on paper.
std::string report(const Verification& verification);

}  // namespace crawford::reports::page
