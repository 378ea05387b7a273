/// The studies of the report's page, with their gates.
#pragma once

#include "reports/page/html.hpp"
#include "reports/verification.hpp"

namespace crawford::reports::page {

/// Every entry of the catalogue with its page, and under it its studies with their gates. What fell
/// short comes first: entries among entries, gates among the gates of a study.
Html study_sections(const Verification& verification);

}  // namespace crawford::reports::page
