/// A verification as a page.
#pragma once

#include <string>

#include "reports/verification.hpp"

namespace crawford::reports::page {

/// The whole report as one page that needs no other file (document.hpp). `figures` is the address
/// of the index of figures, if there is one.
std::string report(const Verification& verification, const std::string& figures = {});

}  // namespace crawford::reports::page
