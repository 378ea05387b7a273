/// A verification in a line a study, with the gates that fall short in full.
#pragma once

#include <string>

#include "reports/verification.hpp"

namespace crawford::reports {

/// What a run has found, for a terminal: a line of at most 80 columns for each study (gates passed
/// and in all, how it came out, seconds), then, as table(), every gate that fell short.
std::string brief(const Verification& verification);

}  // namespace crawford::reports
