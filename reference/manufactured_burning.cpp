#include "reference/manufactured_burning.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "reference/derivatives.hpp"
#include "reference/require.hpp"

namespace crawford::reference {
namespace {

constexpr double two_pi = boost::math::constants::two_pi<double>();

using Eigen::Matrix2d;
using Eigen::Vector2d;

// The fields, templated on the scalar: x, y and t are doubles, or variables to differentiate by.

template <class X, class T>
auto surface_of(const BurningParameters& p, const X& x, const T& t) {
    using std::cos;
    return -p.regression_rate * t +
           p.wave_height * cos(two_pi / p.width * x - p.wave_frequency * t);
}

/// Height above the bottom of the window over its depth: 0 to 1.
template <class S>
S height_of(const BurningParameters& p, const S& x, const S& y, const S& t) {
    return 1.0 + (y - surface_of(p, x, t)) / p.depth;
}

/// T_s of the burn rate that moves the surface as it moves.
template <class S>
S surface_temperature_of(const BurningParameters& p, const S& x, const S& t) {
    using std::log;
    using std::sin;
    using std::sqrt;
    const double k = two_pi / p.width;
    const S wave = p.wave_height * sin(k * x - p.wave_frequency * t);
    const S rate = -p.regression_rate + p.wave_frequency * wave;
    const S slope = -k * wave;
    const S burn_rate = -rate / sqrt(1.0 + slope * slope);
    return p.material.activation_temperature / log(p.material.pyrolysis_prefactor / burn_rate);
}

struct TemperatureField {
    const BurningParameters& p;

    template <class S>
    std::array<S, 1> operator()(const S& x, const S& y, const S& t) const {
        const S h = height_of(p, x, y, t);
        return {p.bottom_temperature +
                (surface_temperature_of(p, x, t) - p.bottom_temperature) * h * h * h};
    }
};

/// Leaves the bottom with zero value and gradient, so that the velocity vanishes there too.
struct ShiftField {
    const BurningParameters& p;

    template <class S>
    std::array<S, 2> operator()(const S& x, const S& y, const S& t) const {
        using std::cos;
        using std::sin;
        const double k = two_pi / p.width;
        const S h = height_of(p, x, y, t);
        const S lifted = p.displacement * h * h;
        return {lifted * sin(k * x + p.motion_frequency * t + 0.3),
                lifted * (0.6 * cos(k * x - 0.7 * p.motion_frequency * t) + 0.4 * h)};
    }
};

/// xx, yy, zz, xy.
struct StressOfPlace {
    const BurningParameters& p;

    template <class S>
    std::array<S, 4> operator()(const S& x, const S& y, const S& t) const {
        using std::cos;
        using std::sin;
        const double k = two_pi / p.width;
        const double f = p.motion_frequency;
        const S h = height_of(p, x, y, t);
        const S rising = p.stress * h * h * h;
        return {rising * sin(k * x - f * t) - p.stress,
                rising * (0.5 + 0.5 * cos(k * x + 0.8 * f * t)) - 0.8 * p.stress,
                0.7 * rising * cos(k * x - 0.4 * f * t) - 0.9 * p.stress,
                0.6 * rising * sin(k * x + 0.6 * f * t + 1.0) + 0.3 * p.stress};
    }
};

Vector2d normal(double slope) {
    return Vector2d(-slope, 1.0) / std::hypot(1.0, slope);
}

}  // namespace

/// xi and what follows from it at one point. With J = grad xi,  J v = -xi_t,  and differentiated
/// along x_k,  J v_k = -(xi_tk + J_k v).
struct ManufacturedBurning::Motion {
    Matrix2d map_gradient;
    Vector2d velocity;
    Matrix2d velocity_gradient;

    explicit Motion(const std::array<Derivatives, 2>& s) {
        Matrix2d along_x, along_y;
        Vector2d rate, rate_x, rate_y;
        for (int i = 0; i < 2; ++i) {
            const Derivatives& d = s[size_t(i)];
            map_gradient.row(i) << d.x, d.y;
            along_x.row(i) << d.xx, d.xy;
            along_y.row(i) << d.xy, d.yy;
            rate[i] = d.t;
            rate_x[i] = d.xt;
            rate_y[i] = d.yt;
        }
        map_gradient += Matrix2d::Identity();
        const Matrix2d inverse = map_gradient.inverse();
        velocity = -inverse * rate;
        velocity_gradient.col(0) = -inverse * (rate_x + along_x * velocity);
        velocity_gradient.col(1) = -inverse * (rate_y + along_y * velocity);
    }
};

ManufacturedBurning::ManufacturedBurning(const BurningParameters& parameters) : p_(parameters) {
    const Material& m = p_.material;
    require_positive("material.thermal_conductivity", m.thermal_conductivity);
    require_positive("material.specific_heat", m.specific_heat);
    require_positive("material.density", m.density);
    require_positive("material.bulk_modulus", m.bulk_modulus);
    require_positive("material.shear_modulus", m.shear_modulus);
    require_finite("material.thermal_expansion", m.thermal_expansion);
    require_positive("material.pyrolysis_prefactor", m.pyrolysis_prefactor);
    require_positive("material.activation_temperature", m.activation_temperature);
    require_finite("material.heat_of_reaction", m.heat_of_reaction);
    require_positive("width", p_.width);
    require_positive("depth", p_.depth);
    require_positive("regression_rate", p_.regression_rate);
    require_not_negative("wave_height", p_.wave_height);
    require_finite("wave_frequency", p_.wave_frequency);
    require_positive("bottom_temperature", p_.bottom_temperature);
    require_finite("displacement", p_.displacement);
    require_finite("motion_frequency", p_.motion_frequency);
    require_finite("stress", p_.stress);
    require_finite("gas_pressure", p_.gas_pressure);
    require_finite("gas_flux", p_.gas_flux);
    const double fastest = p_.regression_rate + std::abs(p_.wave_frequency) * p_.wave_height;
    if (!(std::abs(p_.wave_frequency) * p_.wave_height < p_.regression_rate))
        throw std::invalid_argument(fmt::format(
            "wave_frequency x wave_height = {:.4g} m/s must be below regression_rate = {:.4g} m/s",
            fastest - p_.regression_rate, p_.regression_rate));
    if (!(fastest < m.pyrolysis_prefactor))
        throw std::invalid_argument(
            fmt::format("the surface regresses by up to {:.4g} m/s, which must be below "
                        "material.pyrolysis_prefactor = {:.4g} m/s",
                        fastest, m.pyrolysis_prefactor));
}

ManufacturedBurning::Motion ManufacturedBurning::motion(double x, double y, double t) const {
    return Motion(derivatives(ShiftField{p_}, x, y, t));
}

double ManufacturedBurning::surface(double x, double t) const {
    return surface_of(p_, x, t);
}

double ManufacturedBurning::temperature(double x, double y, double t) const {
    return TemperatureField{p_}(x, y, t)[0];
}

double ManufacturedBurning::temperature_rate(double x, double y, double t) const {
    const Derivatives d = derivatives(TemperatureField{p_}, x, y, t)[0];
    return d.t + velocity(x, y, t).dot(Vector2d(d.x, d.y));
}

Vector2d ManufacturedBurning::velocity(double x, double y, double t) const {
    return motion(x, y, t).velocity;
}

Matrix2d ManufacturedBurning::velocity_gradient(double x, double y, double t) const {
    return motion(x, y, t).velocity_gradient;
}

PlaneStrainStress ManufacturedBurning::stress(double x, double y, double t) const {
    const auto s = StressOfPlace{p_}(x, y, t);
    return {s[0], s[1], s[2], s[3]};
}

Vector2d ManufacturedBurning::shift(double x, double y, double t) const {
    const auto s = ShiftField{p_}(x, y, t);
    return {s[0], s[1]};
}

Matrix2d ManufacturedBurning::deformation_gradient(double x, double y, double t) const {
    return motion(x, y, t).map_gradient.inverse();
}

double ManufacturedBurning::heat_source(double x, double y, double t) const {
    const Material& m = p_.material;
    const Derivatives d = derivatives(TemperatureField{p_}, x, y, t)[0];
    const Motion at = motion(x, y, t);
    const double beta = 3.0 * m.thermal_expansion * m.bulk_modulus;
    return m.density * m.specific_heat * (d.t + at.velocity.dot(Vector2d(d.x, d.y))) -
           m.thermal_conductivity * (d.xx + d.yy) + beta * d.value * at.velocity_gradient.trace();
}

/// S = D(sigma)/Dt + sigma.omega - omega.sigma - C:D + beta (DT/Dt) I,
/// omega = (grad v - grad v^T)/2.
PlaneStrainStress ManufacturedBurning::stress_source(double x, double y, double t) const {
    const Material& m = p_.material;
    const auto s = derivatives(StressOfPlace{p_}, x, y, t);
    const Motion at = motion(x, y, t);
    const Matrix2d& g = at.velocity_gradient;
    const Matrix2d omega = 0.5 * (g - g.transpose());
    const Matrix2d strain_rate = 0.5 * (g + g.transpose());
    const auto carried = [&](const Derivatives& d) {
        return d.t + at.velocity.dot(Vector2d(d.x, d.y));
    };
    Matrix2d sigma;
    sigma << s[0].value, s[3].value, s[3].value, s[1].value;
    const Matrix2d turned = sigma * omega - omega * sigma;
    const double pressed = m.lame() * g.trace() -
                           3.0 * m.thermal_expansion * m.bulk_modulus * temperature_rate(x, y, t);
    const double twice_mu = 2.0 * m.shear_modulus;
    return {carried(s[0]) + turned(0, 0) - pressed - twice_mu * strain_rate(0, 0),
            carried(s[1]) + turned(1, 1) - pressed - twice_mu * strain_rate(1, 1),
            carried(s[2]) - pressed, carried(s[3]) + turned(0, 1) - twice_mu * strain_rate(0, 1)};
}

Vector2d ManufacturedBurning::body_force(double x, double y, double t) const {
    const auto s = derivatives(StressOfPlace{p_}, x, y, t);
    return {-s[0].x - s[3].y, -s[3].x - s[1].y};
}

double ManufacturedBurning::heat_flux(double x, double t) const {
    const Material& m = p_.material;
    const double k = two_pi / p_.width;
    const double slope = -k * p_.wave_height * std::sin(k * x - p_.wave_frequency * t);
    const Derivatives d = derivatives(TemperatureField{p_}, x, surface(x, t), t)[0];
    const double burn_rate = m.pyrolysis_prefactor * std::exp(-m.activation_temperature / d.value);
    return m.thermal_conductivity * normal(slope).dot(Vector2d(d.x, d.y)) - p_.gas_flux -
           m.heat_of_reaction * m.density * burn_rate;
}

Vector2d ManufacturedBurning::traction(double x, double t) const {
    const double k = two_pi / p_.width;
    const double slope = -k * p_.wave_height * std::sin(k * x - p_.wave_frequency * t);
    const PlaneStrainStress s = stress(x, surface(x, t), t);
    Matrix2d sigma;
    sigma << s.xx, s.xy, s.xy, s.yy;
    return sigma * normal(slope) + p_.gas_pressure * normal(slope);
}

}  // namespace crawford::reference
