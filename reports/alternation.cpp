#include "reports/alternation.hpp"

#include <cmath>
#include <stdexcept>

namespace crawford::reports {

double alternation(const std::vector<double>& values) {
    if (values.size() < 5) throw std::invalid_argument("alternation: needs five values");
    double differences = 0.0;
    for (size_t k = 2; k + 2 < values.size(); ++k) {
        const double fourth = values[k - 2] - 4.0 * values[k - 1] + 6.0 * values[k] -
                              4.0 * values[k + 1] + values[k + 2];
        differences += fourth * fourth / 256.0;
    }
    double squares = 0.0;
    for (const double value : values) squares += value * value;
    if (squares == 0.0) return 0.0;
    return std::sqrt(differences / double(values.size() - 4) / (squares / double(values.size())));
}

double alternation_of_half(const std::vector<double>& half, double sign) {
    std::vector<double> whole;
    for (size_t k = half.size(); k-- > 1;) whole.push_back(sign * half[k]);
    whole.insert(whole.end(), half.begin(), half.end());
    return alternation(whole);
}

}  // namespace crawford::reports
