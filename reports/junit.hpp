/// A verification as JUnit XML, a test a gate.
#pragma once

#include <filesystem>

#include "reports/verification.hpp"

namespace crawford::reports {

/// Writes it as JUnit's XML, atomically: a suite for each study, a test for each gate, skipped
/// where it is not gated, with the whole of its numbers where it has failed; where everything was
/// run, the suite "coverage" with a failed test for each gap.
/// \throws InputError naming the file.
void write_junit(const std::filesystem::path& file, const Verification& verification);

}  // namespace crawford::reports
