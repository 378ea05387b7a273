/// One-sided differences of third order (weighted essentially non-oscillatory) and second order
/// (ENO)   (paper ref. 31).
#pragma once

#include <cmath>

namespace crawford {

/// The three undivided differences about a point, seen from upwind: f[0]-f[-1] at the point's
/// upwind side is `near`, the one before it `far`, and the one on the downwind side `ahead`.
template <class Value>
struct UpwindDifferences {
    Value far, near, ahead;
};

/// Third-order WENO derivative, undivided. `smoothness` is the square of a difference too small to
/// matter: without a scale of the field's own the scheme is first order near critical points, or
/// noisy.
inline double weno3(const UpwindDifferences<double>& d, double smoothness) {
    const double upwind = d.near - d.far;
    const double downwind = d.ahead - d.near;
    const double rough = smoothness + upwind * upwind;
    const double rough_ahead = smoothness + downwind * downwind;
    // 1/(1 + 2 (rough/rough_ahead)^2) with one division.
    const double weight =
        rough_ahead * rough_ahead / (rough_ahead * rough_ahead + 2.0 * rough * rough);
    return 0.5 * (d.near + d.ahead) - 0.5 * weight * (downwind - upwind);
}

/// Second-order ENO derivative, undivided: the smaller of the two second differences corrects the
/// upwind one.
inline double eno2(const UpwindDifferences<double>& d) {
    const double upwind = d.near - d.far;
    const double downwind = d.ahead - d.near;
    return d.near + 0.5 * (std::abs(upwind) < std::abs(downwind) ? upwind : downwind);
}

}  // namespace crawford
