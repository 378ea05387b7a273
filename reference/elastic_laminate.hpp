/// Layers side by side, pressed from above.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "reference/material.hpp"
#include "reference/plane_strain_stress.hpp"

namespace crawford::reference {

/// A periodic laminate of two materials: a strip of `inner` about x = 0, `outer` to the end of the
/// period, layers along y.
struct LaminateConditions {
    Material inner, outer;      ///< K and mu are used
    double period = missing;    ///< In x [m]
    double strip = missing;     ///< Width of the inner layer [m], less than the period
    double axial_strain = 0.0;  ///< eps_yy, common to all layers
    double shear = 0.0;         ///< G: u grows by G y
};

/// The laminate in plane strain, in closed form. Every layer strains evenly; sigma_xx and sigma_xy
/// are the same in all of them, and no period grows: the mean of eps_xx is zero.
///
///     u = int_0^x eps_xx dx + G y,   v = eps_yy y + int_0^x (sigma_xy/mu - G) dx
///
/// Bilinear elements on grid lines along the interfaces hold this field exactly.
class ElasticLaminate {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit ElasticLaminate(const LaminateConditions& conditions);

    Eigen::Vector2d displacement(double x, double y) const;  ///< (u, v) [m], any x
    PlaneStrainStress stress(double x) const;  ///< [Pa]; on an interface that of the inner layer
    double stress_xx() const { return stress_xx_; }  ///< [Pa]
    double stress_xy() const { return stress_xy_; }  ///< [Pa]

private:
    struct Layer {
        double lame, shear_modulus;
        double strain_xx = 0.0, shear_strain = 0.0;  // shear: dv/dx
    };
    bool is_inner(double x) const;
    /// Of what is `inner` in the strip and `outer` beside it, from 0 to x.
    double integral(double inner, double outer, double x) const;

    LaminateConditions conditions_;
    Layer inner_, outer_;
    double stress_xx_ = 0.0;
    double stress_xy_ = 0.0;
};

/// A layer of any laminate: its material and what share of the period it takes.
struct LayerShare {
    Material material;
    double share = missing;
};

/// Mean sigma_yy of a laminate for eps_yy = 1, with no shear and no growth of the period [Pa]:
/// <P> - <lambda^2/P> + <lambda/P>^2/<1/P>, P = lambda + 2 mu, <> the mean over the layers.
/// \throws std::invalid_argument naming what is out of range, unless the shares add to 1
double axial_stiffness(const std::vector<LayerShare>& layers);

/// The material of the strip that makes sigma_yy the same in both layers of a laminate under axial
/// strain, so that an even pressure on its end leaves the end flat:
///
///     mu_i = mu_o (1 - a)/(1 + a r),   (lambda + mu)_i = (lambda + mu)_o (1 + a)/(1 - a r)
///
/// with r = (period - strip)/strip. The softer it is in shear, the stiffer in bulk.
/// \param a eps_xx/eps_yy of the outer layer, 0 for equal materials
/// \throws std::invalid_argument unless 0 <= a < min(1, 1/r)
Material balanced_strip(const Material& outer, double strip, double period, double a);

}  // namespace crawford::reference
