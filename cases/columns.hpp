/// Columns of numbers for figures.
#pragma once

#include <vector>

namespace crawford {

/// All values in another unit: 3e-6 m in units of um is 3.
inline std::vector<double> scaled(std::vector<double> values, double unit) {
    for (double& value : values) value /= unit;
    return values;
}

/// All values less the first one.
inline std::vector<double> above_first(std::vector<double> values) {
    const double first = values.front();
    for (double& value : values) value -= first;
    return values;
}

}  // namespace crawford
