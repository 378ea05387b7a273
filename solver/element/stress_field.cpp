#include "solver/element/stress_field.hpp"

namespace crawford {

PlaneStress StressField::mean(int i, int j) const {
    Deviator sum;
    for (const auto& point : deviator) sum = sum + point(i, j);
    const double share = 1.0 / points();
    const double p = pressure(i, j);
    return {share * sum.s11 - p, share * sum.s22 - p, -share * (sum.s11 + sum.s22) - p,
            share * sum.s12};
}

}  // namespace crawford
