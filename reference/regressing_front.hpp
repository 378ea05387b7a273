/// Exact solutions of phi_t = -r_b sqrt(1 + phi_x^2), r_b constant (paper eq. 9).
///
/// The surface recedes along its normal at r_b, so Huygens' construction solves it (the Hopf-Lax
/// formula): phi(x, t) is the lower envelope of circles of radius r_b t about the points of the
/// first surface. Crests sharpen into kinks, kinks that point down open into arcs.
#pragma once

namespace crawford::reference {

/// The surface that starts as phi = A cos(2 pi x/L). Until its crests kink every characteristic
/// x = x0 + t r_b p/sqrt(1 + p^2) carries its slope p = phi_x unchanged.
class RegressingWave {
public:
    /// \param amplitude A [m], >= 0
    /// \param period L [m]
    /// \param burn_rate r_b [m/s]
    /// \throws std::invalid_argument naming the parameter that is missing or not in its range.
    RegressingWave(double amplitude, double period, double burn_rate);

    /// When the crests kink [s]: the time in which the front burns through their radius of
    /// curvature, 1/(A k^2); infinite for a level surface.
    double kink_time() const;

    /// phi(x, t) [m] along the characteristic through (x, t).
    /// \throws std::invalid_argument if t [s] is negative or not before kink_time().
    double height(double x, double t) const;
    /// phi_x, as height().
    double slope(double x, double t) const;

    /// phi(x, t) [m] by the Hopf-Lax formula, minimised numerically: good to some 1e-13 of L,
    /// before the kink and after it.
    /// \throws std::invalid_argument if t is negative.
    double envelope(double x, double t) const;

private:
    double start(double x) const;
    double start_slope(double x) const;
    double foot(double x, double t) const;  // x0 of the characteristic through (x, t)

    double amplitude_, wave_number_, burn_rate_;
};

/// The surface that starts as a zigzag, lowest at x = 0, L, 2 L, ...: the kinks at its valleys open
/// into arcs of radius r_b t, those at its crests stay and, between unequal slopes, wander.
class RegressingZigzag {
public:
    /// \param right slope to the right of a valley, > 0
    /// \param left steepness to the left of it, > 0
    /// \param period L [m]
    /// \param burn_rate r_b [m/s]
    /// \throws std::invalid_argument naming the parameter that is missing or not positive.
    RegressingZigzag(double right, double left, double period, double burn_rate);

    /// phi(x, t) [m]: the lowest of the fronts that start from each valley alone.
    /// \throws std::invalid_argument if t [s] is negative.
    double height(double x, double t) const;

private:
    double valley(double x, double t) const;

    double right_, left_, period_, burn_rate_;
};

}  // namespace crawford::reference
