#include "reference/williams_corner.hpp"

#include <Eigen/Dense>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"
#include "reference/root.hpp"

namespace crawford::reference {

namespace {

using Block = Eigen::Matrix4d;  // rows: sigma_tt, sigma_rt, 2 u_r, 2 u_t; columns: coefficients
constexpr double pi = boost::math::constants::pi<double>();

void require_moduli(const Material& a, const Material& b) {
    require_positive("bulk modulus of a", a.bulk_modulus);
    require_positive("shear modulus of a", a.shear_modulus);
    require_positive("bulk modulus of b", b.bulk_modulus);
    require_positive("shear modulus of b", b.shear_modulus);
}

/// Kolosov's constant 3 - 4 nu.
double kolosov(const Material& material) {
    return 1.0 + 2.0 * material.shear_modulus / (material.lame() + material.shear_modulus);
}

/// Stress and displacement at r = 1 of the four solutions whose Airy functions are r^(lambda + 1)
/// times sin, cos of (lambda + 1) theta and sin, cos of (lambda - 1) theta.
Block solutions(double kappa, double shear, double lambda, double theta) {
    const double p = lambda + 1.0;
    const double m = lambda - 1.0;
    const double sp = std::sin(p * theta);
    const double cp = std::cos(p * theta);
    const double sm = std::sin(m * theta);
    const double cm = std::cos(m * theta);
    Block rows;
    rows.row(0) = lambda * p * Eigen::RowVector4d(sp, cp, sm, cm);
    rows.row(1) = -lambda * Eigen::RowVector4d(p * cp, -p * sp, m * cm, -m * sm);
    rows.row(2) =
        Eigen::RowVector4d(-p * sp, -p * cp, (kappa - lambda) * sm, (kappa - lambda) * cm) / shear;
    rows.row(3) =
        Eigen::RowVector4d(-p * cp, p * sp, -(kappa + lambda) * cm, (kappa + lambda) * sm) / shear;
    return rows;
}

}  // namespace

Dundurs dundurs(const Material& a, const Material& b) {
    require_moduli(a, b);
    const double from_a = b.shear_modulus * (kolosov(a) + 1.0);
    const double from_b = a.shear_modulus * (kolosov(b) + 1.0);
    const double bulk = b.shear_modulus * (kolosov(a) - 1.0) - a.shear_modulus * (kolosov(b) - 1.0);
    return {.alpha = (from_a - from_b) / (from_a + from_b), .beta = bulk / (from_a + from_b)};
}

double williams_determinant(const Material& a, const Material& b, double lambda) {
    require_moduli(a, b);
    require_positive("lambda", lambda);
    const double ratio = b.shear_modulus / a.shear_modulus;
    Eigen::Matrix<double, 8, 8> equations = Eigen::Matrix<double, 8, 8>::Zero();
    equations.block<2, 4>(0, 0) = solutions(kolosov(a), 1.0, lambda, 0.5 * pi).topRows<2>();
    equations.block<2, 4>(2, 4) = solutions(kolosov(b), ratio, lambda, -0.5 * pi).topRows<2>();
    equations.block<4, 4>(4, 0) = solutions(kolosov(a), 1.0, lambda, 0.0);
    equations.block<4, 4>(4, 4) = -solutions(kolosov(b), ratio, lambda, 0.0);
    return equations.determinant();
}

double bogy_function(const Dundurs& contrast, double lambda) {
    const double square = lambda * lambda;
    const double gap = std::pow(std::sin(0.5 * pi * lambda), 2) - square;
    return square * (square - 1.0) * contrast.alpha * contrast.alpha +
           2.0 * square * gap * contrast.alpha * contrast.beta +
           gap * gap * contrast.beta * contrast.beta + 0.25 * std::pow(std::sin(pi * lambda), 2);
}

double corner_exponent(const Material& a, const Material& b) {
    constexpr int steps = 500;
    const auto determinant = [&](double lambda) { return williams_determinant(a, b, lambda); };
    // Stops short of lambda = 1, a zero of every pair: a rigid rotation.
    for (int k = 1; k + 1 < steps; ++k) {
        const double low = double(k) / steps;
        const double high = double(k + 1) / steps;
        if (determinant(low) * determinant(high) <= 0.0)
            return bracketed_root(determinant, low, high);
    }
    throw std::invalid_argument("corner of these two materials has no real exponent below 1");
}

double even_stress(const Material& a, const Material& b, double pressure) {
    require_moduli(a, b);
    require_finite("pressure", pressure);
    // Strain along the interface: ((lambda + 2 mu) sigma_nn - lambda s)/(4 mu (lambda + mu)).
    const auto compliance = [](const Material& m, double modulus) {
        return modulus / (4.0 * m.shear_modulus * (m.lame() + m.shear_modulus));
    };
    const double along = compliance(a, a.lame()) - compliance(b, b.lame());
    const double across = compliance(a, a.uniaxial_modulus()) - compliance(b, b.uniaxial_modulus());
    if (along == 0.0)
        throw std::invalid_argument("even stress of two materials that contract alike is free");
    return -pressure * across / along;
}

}  // namespace crawford::reference
