#include "solver/step/state.hpp"

namespace crawford {

namespace {

template <class Value>
void combine(double a, std::vector<Value>& x, double b, const std::vector<Value>& y) {
    for (size_t k = 0; k < x.size(); ++k) x[k] = a * x[k] + b * y[k];
}

}  // namespace

State combination(double a, const State& x, double b, const State& y) {
    State sum = x;
    combine(a, sum.surface, b, y.surface);
    combine(a, sum.temperature.values(), b, y.temperature.values());
    combine(a, sum.velocity.values(), b, y.velocity.values());
    for (size_t k = 0; k < sum.stress.deviator.size(); ++k)
        combine(a, sum.stress.deviator[k].values(), b, y.stress.deviator[k].values());
    combine(a, sum.stress.pressure.values(), b, y.stress.pressure.values());
    combine(a, sum.temperature_rate.values(), b, y.temperature_rate.values());
    combine(a, sum.reference_shift.values(), b, y.reference_shift.values());
    return sum;
}

}  // namespace crawford
