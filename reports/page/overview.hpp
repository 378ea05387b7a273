/// What a report says first.
#pragma once

#include "reports/page/html.hpp"
#include "reports/verification.hpp"

namespace crawford::reports::page {

/// The verdict in a line, when and on what it was reached, and links to all that fell short.
Html headline(const Verification& verification);

/// Every entry of the catalogue with how many of its gates have come out how, what it cost, and
/// its studies.
Html table_of_studies(const Verification& verification);

/// Where an entry of the catalogue, and where a study, stand in the page.
std::string anchor_of_entry(const std::string& name);
std::string anchor_of_study(const std::string& name);

/// The entries of the catalogue that studies come from, each once.
std::vector<std::string> entries_of(const Verification& verification);

/// The gates of all studies of an entry.
std::vector<GateResult> gates_of(const Verification& verification, const std::string& entry);

}  // namespace crawford::reports::page
