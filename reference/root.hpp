/// The root of a function between two ends.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <numeric>

namespace crawford::reference {

/// Root of f in [low, high], whose ends must have opposite signs, to the last bits of a double
/// (Boost's TOMS 748).
template <typename Function>
double bracketed_root(const Function& f, double low, double high) {
    constexpr int bits = 51;
    std::uintmax_t iterations = 200;
    const auto [left, right] = boost::math::tools::toms748_solve(
        f, low, high, boost::math::tools::eps_tolerance<double>(bits), iterations);
    return std::midpoint(left, right);
}

}  // namespace crawford::reference
