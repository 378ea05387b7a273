/// What nothing beats: the settings that are worth their cost.
#pragma once

#include <cstddef>
#include <vector>

namespace crawford::reports {

/// One setting; both numbers are better when smaller. A NaN is never on a front.
struct Traded {
    double cost;
    double error;
};

/// Indices of the points than which none is both cheaper and more accurate, by rising cost. Of
/// equals the first counts.
std::vector<std::size_t> pareto_front(const std::vector<Traded>& points);

}  // namespace crawford::reports
