/// Upwind differences among cells that hold the same material.
#pragma once

#include <array>

#include "solver/element/stress_field.hpp"
#include "solver/mesh/weno.hpp"

namespace crawford {

/// A cell and two neighbours on each side of it, in one direction of the grid. A neighbour is
/// closed where it lies beyond the grid or in another material, or behind a closed one: its value
/// is not read.
template <class Value>
struct Neighbourhood {
    std::array<Value, 5> value;
    std::array<bool, 5> open;
};

// Differences of 1 kPa between neighbours are smooth: stresses that matter are MPa.
constexpr double smooth_stress_squared = 1e6;  // [Pa^2]

inline double upwind_derivative(const UpwindDifferences<double>& d) {
    return weno3(d, smooth_stress_squared);
}

inline Deviator upwind_derivative(const UpwindDifferences<Deviator>& d) {
    const auto component = [&](double Deviator::*c) {
        return weno3({d.far.*c, d.near.*c, d.ahead.*c}, smooth_stress_squared);
    };
    return {component(&Deviator::s11), component(&Deviator::s22), component(&Deviator::s12)};
}

/// Undivided derivative at the middle cell for a flow of the sign of `velocity`: third-order WENO
/// where all cells are open; second order, one-sided or central, where one is not; zero where the
/// upwind neighbour is closed, so that what flows in is what is there.
template <class Value>
Value upwind_derivative(const Neighbourhood<Value>& f, double velocity) {
    const bool forward = velocity > 0.0;
    const double sign = forward ? 1.0 : -1.0;
    const auto at = [&](int k) { return size_t(forward ? 2 + k : 2 - k); };
    const auto difference = [&](int k) { return sign * (f.value[at(k)] - f.value[at(k - 1)]); };

    if (!f.open[at(-1)]) return Value{};
    const Value near = difference(0);
    const bool has_far = f.open[at(-2)];
    const bool has_ahead = f.open[at(1)];
    if (!has_far && !has_ahead) return near;
    if (!has_far) return 0.5 * (near + difference(1));
    if (!has_ahead) return 1.5 * near - 0.5 * difference(-1);
    return upwind_derivative(UpwindDifferences<Value>{difference(-1), near, difference(1)});
}

}  // namespace crawford
