/// The mechanical sandwich by finite elements of high degree.
#pragma once

#include <Eigen/Dense>

#include "reference/plane_strain_stress.hpp"
#include "reference/sandwich_geometry.hpp"

namespace crawford::reference {

/// How the bottom is held.
enum class Support {
    clamped,  ///< u = v = 0
    roller,   ///< v = 0, u free
};

/// A cold sandwich under a pressure on its flat surface: small-strain linear elasticity in plane
/// strain, by finite elements of high degree on a mesh graded geometrically towards the interface
/// and both ends of it. Where interface and surface meet the stress is singular (about r^-0.405 for
/// AP and binder); away from there, results converge exponentially in the degree. From degree 4 on,
/// plain displacement elements do not lock at K/mu = 4268.
///
/// One quasi-static step from a stress-free state obeys the same equations: displacement = velocity
/// * dt.
class ElasticSandwich {
public:
    /// \param pressure p_c [Pa] on the surface, downwards.
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    ElasticSandwich(const SandwichGeometry& geometry, double pressure, Support support,
                    const SandwichElements& elements = {});

    /// (u, v) [m] at |x| <= half_width, -depth <= y <= 0.
    Eigen::Vector2d displacement(double x, double y) const;
    /// At |x| <= half_width; on the interface that of the strip. Shear stress changes sign with x.
    PlaneStrainStress stress(double x, double y) const;
    double pressure(double x, double y) const { return stress(x, y).pressure(); }  ///< [Pa]

private:
    void assemble_and_solve(double pressure, Support support);

    SandwichGeometry geometry_;
    TensorSpace space_;
    Eigen::VectorXd displacement_;  // u and v of each node [m]
};

}  // namespace crawford::reference
