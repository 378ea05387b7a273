#include "reports/default_estimate.hpp"

namespace crawford::reports {

Extrapolation default_limit(std::span<const double> h, std::span<const double> values,
                            double formal_order) {
    return extrapolate(h, values, formal_order);
}

}  // namespace crawford::reports
