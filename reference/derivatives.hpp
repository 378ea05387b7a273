/// Derivatives of manufactured solutions by forward automatic differentiation: exact to round-off,
/// with no formula worked out by hand.
#pragma once

#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <cstddef>
#include <tuple>

namespace crawford::reference {

/// A scalar at one point and time: in its own unit, over m and s as often as differentiated.
struct Derivatives {
    double value;
    double x, y, t;     ///< first derivatives
    double xx, xy, yy;  ///< second derivatives
    double xt, yt;      ///< of the rate
};

/// Derivatives of each component of `field(x, y, t)`, a callable templated on its scalar that
/// returns std::array<scalar, N>.
template <class Field>
auto derivatives(const Field& field, double x, double y, double t) {
    const auto at = boost::math::differentiation::make_ftuple<double, 2, 2, 1>(x, y, t);
    using Scalar = boost::math::differentiation::autodiff_fvar<double, 2, 2, 1>;
    const auto values =
        field(Scalar(std::get<0>(at)), Scalar(std::get<1>(at)), Scalar(std::get<2>(at)));
    std::array<Derivatives, std::tuple_size_v<std::remove_const_t<decltype(values)>>> result;
    for (std::size_t k = 0; k < result.size(); ++k) {
        const auto& f = values[k];
        result[k] = {f.derivative(0, 0, 0), f.derivative(1, 0, 0), f.derivative(0, 1, 0),
                     f.derivative(0, 0, 1), f.derivative(2, 0, 0), f.derivative(1, 1, 0),
                     f.derivative(0, 2, 0), f.derivative(1, 0, 1), f.derivative(0, 1, 1)};
    }
    return result;
}

/// The same of `field(x, y)`, which does not change in time; cheaper.
template <class Field>
auto derivatives(const Field& field, double x, double y) {
    const auto at = boost::math::differentiation::make_ftuple<double, 2, 2>(x, y);
    using Scalar = boost::math::differentiation::autodiff_fvar<double, 2, 2>;
    const auto values = field(Scalar(std::get<0>(at)), Scalar(std::get<1>(at)));
    std::array<Derivatives, std::tuple_size_v<std::remove_const_t<decltype(values)>>> result;
    for (std::size_t k = 0; k < result.size(); ++k) {
        const auto& f = values[k];
        result[k] = {f.derivative(0, 0),
                     f.derivative(1, 0),
                     f.derivative(0, 1),
                     0.0,
                     f.derivative(2, 0),
                     f.derivative(1, 1),
                     f.derivative(0, 2),
                     0.0,
                     0.0};
    }
    return result;
}

}  // namespace crawford::reference
