/// How much of a line of values alternates from one to the next.
#pragma once

#include <vector>

namespace crawford::reports {

/// Rms of the fourth difference, over 16, relative to the rms of the values: 1 for a pure zigzag, 0
/// for a cubic.
/// \throws std::invalid_argument for fewer than five values
double alternation(const std::vector<double>& values);

/// The same for half a line that continues as its mirror image before its first value; `sign` is -1
/// for what changes sign there.
double alternation_of_half(const std::vector<double>& half, double sign);

}  // namespace crawford::reports
