/// Upwind differences among cells that hold the same material.
#pragma once

#include "solver/element/stress_field.hpp"
#include "solver/mesh/weno.hpp"

namespace crawford {

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

/// Undivided derivative at the middle of five cells for a flow of the sign of `velocity`:
/// third-order WENO where all cells are open; second order, one-sided or central, where one is not;
/// zero where the upwind neighbour is closed, so that what flows in is what is there.
/// \param open open(k): whether the cell k places on, -2 to 2, may be read
/// \param value value(k): what it holds; not asked of a closed one
template <class Value, class Open, class Read>
Value upwind_derivative(double velocity, const Open& open, const Read& value) {
    const int side = velocity > 0.0 ? 1 : -1;
    if (!open(-side)) return Value{};
    const Value here = value(0);
    const Value behind = value(-side);
    const Value near = double(side) * (here - behind);
    const bool has_far = open(-2 * side);
    const bool has_ahead = open(side);
    if (!has_far && !has_ahead) return near;
    const auto ahead = [&] { return double(side) * (value(side) - here); };
    const auto far = [&] { return double(side) * (behind - value(-2 * side)); };
    if (!has_far) return 0.5 * (near + ahead());
    if (!has_ahead) return 1.5 * near - 0.5 * far();
    return upwind_derivative(UpwindDifferences<Value>{far(), near, ahead()});
}

}  // namespace crawford
