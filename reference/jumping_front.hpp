/// Exact solution of phi_t = -r(x) sqrt(1 + phi_x^2) with a speed that jumps across vertical
/// interfaces, phi = 0 at the start.
///
/// The front at time t is all that fastest paths from the first surface have just reached. In the
/// faster material they run straight down. In the slower one they do too, or they run down the
/// interface in the faster material and leave it under the critical angle, the head wave of
/// seismology: the faster side leads, and drags a plane of slope sqrt((r_fast/r_slow)^2 - 1)
/// through the slower one. That is the viscosity solution; a front whose interface moves with any
/// mean of the two rates is not.
#pragma once

#include <vector>

#include "reference/material.hpp"

namespace crawford::reference {

/// A periodic solid of two burn rates: a strip for left <= x <= right, another material around it.
struct JumpingRate {
    double width = missing;       ///< period in x [m]
    double left = missing;        ///< [m]
    double right = missing;       ///< [m], above left by less than the period
    double strip_rate = missing;  ///< r_b [m/s] in the strip
    double outer_rate = missing;  ///< r_b [m/s] around it
};

class JumpingFront {
public:
    /// \throws std::invalid_argument naming the parameter that is missing or out of range.
    explicit JumpingFront(const JumpingRate& rate);

    double rate(double x) const;  ///< r(x) [m/s]; on an interface the larger

    /// phi(x, t) [m].
    /// \throws std::invalid_argument if t [s] is negative.
    double height(double x, double t) const;
    /// phi_x; at a kink that of one of its sides. \see height
    double slope(double x, double t) const;
    /// Mean of phi over a period [m]. \see height
    double mean_height(double t) const;
    /// Where the slope jumps [m], ascending in [left, left + width): the two interfaces, and in the
    /// slower material where head waves meet its own level front or each other. \see height
    std::vector<double> kinks(double t) const;

private:
    double head_slope() const;
    double head_reach(double t) const;  // how far head waves lead into the slower material [m]
    bool strip_is_faster() const { return rate_.strip_rate >= rate_.outer_rate; }
    double strip() const { return rate_.right - rate_.left; }
    double slower_width() const;
    double slower_left() const;
    double place_in_slower(double x) const;

    JumpingRate rate_;
    double faster_, slower_;
};

}  // namespace crawford::reference
