/// Motions whose particles are followed in closed form, on the grids where the reference map is
/// judged.
#pragma once

#include "cases/units.hpp"
#include "cases/verify/prescribed_motion.hpp"
#include "reports/measurement.hpp"

namespace crawford {

/// What a study needs to know of a motion, at the time it looks at it.
struct FollowedMotion {
    std::function<Vector(Vector x)> velocity;           ///< [m/s]
    std::function<Vector(Vector x)> origin;             ///< xi [m]
    std::function<Eigen::Matrix2d(Vector x)> gradient;  ///< F
    std::function<Eigen::Matrix2d(Vector x)> strain;    ///< E
};

/// A motion of reference/exact_motions.hpp at the time t [s].
template <class Exact>
FollowedMotion followed(const Exact& exact, double t) {
    using Eigen::Matrix2d;
    return {.velocity = [=](const Vector& x) { return exact.velocity(x); },
            .origin = [=](const Vector& x) { return exact.origin(x, t); },
            .gradient =
                [=](const Vector& x) {
                    if constexpr (requires { exact.deformation_gradient(x, t); })
                        return exact.deformation_gradient(x, t);
                    else
                        return exact.deformation_gradient(t);
                },
            .strain = [=](const Vector& x) -> Matrix2d {
                if constexpr (requires { exact.strain(x, t); })
                    return exact.strain(x, t);
                else if constexpr (requires { exact.strain(t); })
                    return exact.strain(t);
                else
                    return Matrix2d::Zero();
            }};
}

/// One grid for all: a square below a curved surface, clustered, that moves at a rate of its own at
/// every place.
namespace wavy_square {

inline constexpr double width = 240.0 * units::um;
inline constexpr double burn_rate = 4.5e-3 * units::m / units::s;

double surface(double x);       ///< phi [m]
double surface_rate(double x);  ///< phi_t [m/s]
PrescribedMotion body(const FollowedMotion& motion, int cells);

/// A rotation and a shear are not periodic: what stencils beyond the sides read is left out.
bool is_inside(const Vector& x);

}  // namespace wavy_square

/// The exact shift xi - x [m] of every node.
NodeVectors shift_of(const PrescribedMotion& body, const FollowedMotion& motion);

/// Reports the errors of "F" and "E" of the cells inside the sides.
void report_gradients(const PrescribedMotion& body, const NodeVectors& shift,
                      const FollowedMotion& motion, reports::Measurement& to);

/// How far the worst entries of F and E are from the truth; report_gradients reports them too.
inline constexpr auto worst_f = "F, worst entry - exact";
inline constexpr auto worst_e = "E, worst entry - exact";

}  // namespace crawford
