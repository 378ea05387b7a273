#include "reference/elastic_laminate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

namespace {

void require_widths(double strip, double period) {
    require_positive("strip", strip);
    require_positive("period", period);
    if (strip >= period)
        throw std::invalid_argument(
            fmt::format("strip = {} must be less than the period, {}", strip, period));
}

void require_moduli(const Material& material, const std::string& layer) {
    require_positive("bulk modulus of the " + layer, material.bulk_modulus);
    require_positive("shear modulus of the " + layer, material.shear_modulus);
}

}  // namespace

ElasticLaminate::ElasticLaminate(const LaminateConditions& conditions) : conditions_(conditions) {
    require_widths(conditions.strip, conditions.period);
    require_moduli(conditions.inner, "inner layer");
    require_moduli(conditions.outer, "outer layer");
    require_finite("axial strain", conditions.axial_strain);
    require_finite("shear", conditions.shear);

    inner_ = {.lame = conditions.inner.lame(), .shear_modulus = conditions.inner.shear_modulus};
    outer_ = {.lame = conditions.outer.lame(), .shear_modulus = conditions.outer.shear_modulus};
    const double share = conditions.strip / conditions.period;
    const auto mean = [&](double inner, double outer) {
        return share * inner + (1.0 - share) * outer;
    };
    const double stretch_inner = inner_.lame + 2.0 * inner_.shear_modulus;
    const double stretch_outer = outer_.lame + 2.0 * outer_.shear_modulus;

    // eps_xx = (sigma_xx - lambda eps_yy)/(lambda + 2 mu) has no mean.
    stress_xx_ = conditions.axial_strain *
                 mean(inner_.lame / stretch_inner, outer_.lame / stretch_outer) /
                 mean(1.0 / stretch_inner, 1.0 / stretch_outer);
    inner_.strain_xx = (stress_xx_ - inner_.lame * conditions.axial_strain) / stretch_inner;
    outer_.strain_xx = (stress_xx_ - outer_.lame * conditions.axial_strain) / stretch_outer;

    // dv/dx = sigma_xy/mu - G has no mean.
    stress_xy_ = conditions.shear / mean(1.0 / inner_.shear_modulus, 1.0 / outer_.shear_modulus);
    inner_.shear_strain = stress_xy_ / inner_.shear_modulus - conditions.shear;
    outer_.shear_strain = stress_xy_ / outer_.shear_modulus - conditions.shear;
}

bool ElasticLaminate::is_inner(double x) const {
    return std::abs(std::remainder(x, conditions_.period)) <= 0.5 * conditions_.strip;
}

/// Nothing is left of a whole period, so x may be brought into the one about 0.
double ElasticLaminate::integral(double inner, double outer, double x) const {
    const double within = std::remainder(x, conditions_.period);
    const double in_strip = std::clamp(within, -0.5 * conditions_.strip, 0.5 * conditions_.strip);
    return inner * in_strip + outer * (within - in_strip);
}

Eigen::Vector2d ElasticLaminate::displacement(double x, double y) const {
    return {integral(inner_.strain_xx, outer_.strain_xx, x) + conditions_.shear * y,
            integral(inner_.shear_strain, outer_.shear_strain, x) + conditions_.axial_strain * y};
}

PlaneStrainStress ElasticLaminate::stress(double x) const {
    const Layer& layer = is_inner(x) ? inner_ : outer_;
    const double volumetric = layer.lame * (layer.strain_xx + conditions_.axial_strain);
    return {.xx = stress_xx_,
            .yy = volumetric + 2.0 * layer.shear_modulus * conditions_.axial_strain,
            .zz = volumetric,
            .xy = stress_xy_};
}

double axial_stiffness(const std::vector<LayerShare>& layers) {
    double shares = 0.0;
    double stretch = 0.0;
    double lateral = 0.0;
    double ratio = 0.0;
    double compliance = 0.0;
    for (const auto& [material, share] : layers) {
        require_moduli(material, "layer");
        require_positive("share of a layer", share);
        const double lame = material.lame();
        const double modulus = material.uniaxial_modulus();
        shares += share;
        stretch += share * modulus;
        lateral += share * lame * lame / modulus;
        ratio += share * lame / modulus;
        compliance += share / modulus;
    }
    if (!(std::abs(shares - 1.0) < 1e-12))
        throw std::invalid_argument(fmt::format("shares of the layers add to {}, not 1", shares));
    return stretch - lateral + ratio * ratio / compliance;
}

Material balanced_strip(const Material& outer, double strip, double period, double a) {
    require_widths(strip, period);
    require_moduli(outer, "outer layer");
    const double r = (period - strip) / strip;
    const double limit = std::min(1.0, 1.0 / r);
    if (!(a >= 0.0 && a < limit))
        throw std::invalid_argument(fmt::format("a = {} must be from 0 to below {}", a, limit));
    const double plane_bulk = outer.lame() + outer.shear_modulus;
    Material inner = outer;
    inner.shear_modulus = outer.shear_modulus * (1.0 - a) / (1.0 + a * r);
    inner.bulk_modulus = plane_bulk * (1.0 + a) / (1.0 - a * r) - inner.shear_modulus / 3.0;
    return inner;
}

}  // namespace crawford::reference
