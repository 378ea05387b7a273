/// Which study would see a fault in which term, as a table.
#pragma once

#include "reports/page/html.hpp"
#include "reports/verification.hpp"

namespace crawford::reports::page {

/// Terms of the equations against studies: a dot where the study would see a fault in the term. A
/// term that no study covers is a red row.
Html coverage_matrix(const Verification& verification);

}  // namespace crawford::reports::page
