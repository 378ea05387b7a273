/// The corner where two bonded materials meet a free surface, a quarter plane of each, plane
/// strain: beside it stress grows as r^(lambda - 1).
///
/// Williams (1952): in each quarter plane Airy's function is r^(lambda + 1) times a combination of
/// sin and cos of (lambda +- 1) theta. Two free edges, and an interface that carries traction and
/// displacement over, leave eight homogeneous equations for eight coefficients; lambda is where
/// their determinant vanishes. Bogy (1968) found the same condition by Mellin transform, in closed
/// form in Dundurs' two parameters.
#pragma once

#include "reference/material.hpp"

namespace crawford::reference {

/// Dundurs' parameters of two materials in plane strain: all that their elastic contrast can do to
/// stresses under given tractions.
struct Dundurs {
    double alpha;  ///< Contrast of the stiffnesses under uniaxial stress; 1 where `b` is rigid
    double beta;   ///< Contrast of the bulk stiffnesses in the plane
};

/// \throws std::invalid_argument naming a modulus that is missing or not positive.
Dundurs dundurs(const Material& a, const Material& b);

/// Determinant of Williams' eight equations, assembled numerically with moduli divided by the
/// shear modulus of `a`; its size means nothing, its zeros are the exponents.
/// \throws std::invalid_argument naming a parameter that is out of range, unless 0 < lambda.
double williams_determinant(const Material& a, const Material& b, double lambda);

/// Bogy's characteristic function of two bonded quarter planes; zero where williams_determinant is.
double bogy_function(const Dundurs& contrast, double lambda);

/// The strongest singularity with a real exponent: the least lambda in (0, 1) where
/// williams_determinant changes sign. 0.59502 for AP and binder of Table 1.
/// \throws std::invalid_argument if a modulus is out of range, or if the pair has no such exponent:
/// stress is bounded where alpha (alpha - 2 beta) <= 0.
double corner_exponent(const Material& a, const Material& b);

/// What the singular field is added to where a pressure p_c [Pa] loads the free surface: sigma_nn =
/// -p_c, no shear, and along the surface this even stress [Pa], common to both materials because
/// the interface strains alike on both sides. It is the lambda = 1 of the corner.
/// \throws std::invalid_argument if a modulus is out of range, if both materials have one Poisson
/// contrast (any stress would do), or if the pressure is no number.
double even_stress(const Material& a, const Material& b, double pressure);

}  // namespace crawford::reference
