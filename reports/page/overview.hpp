#pragma once

#include "reports/page/html.hpp"
#include "reports/verification.hpp"

namespace crawford::reports::page {

/// The verdict in a line, when and on what it was reached, and links to all that fell short.
Html headline(const Verification& verification);

/// Every study with how many of its gates have come out how, and what it cost.
Html table_of_studies(const Verification& verification);

/// Where a study stands in the page.
std::string anchor_of_study(const std::string& name);

/// The gates of a study.
std::vector<GateResult> gates_of(const Verification& verification, const std::string& study);

}  // namespace crawford::reports::page
