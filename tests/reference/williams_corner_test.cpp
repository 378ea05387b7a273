#include "reference/williams_corner.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "reference/root.hpp"

namespace crawford::reference {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

Material elastic(double poisson, double shear) {
    Material material;
    material.shear_modulus = shear;
    material.bulk_modulus = 2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson));
    return material;
}

TEST(WilliamsCorner, OfTheSandwich) {
    EXPECT_NEAR(corner_exponent(ap(), binder()), 0.59502, 5e-6);
    EXPECT_NEAR(corner_exponent(binder(), ap()), corner_exponent(ap(), binder()), 1e-12);
}

// Bogy's closed form comes from a Mellin transform and knows only Dundurs' parameters; the
// determinant is assembled from Airy functions and knows four moduli. Size of Bogy's function: 1/4.
TEST(WilliamsCorner, DeterminantAndBogyVanishTogether) {
    for (const double poisson_a : {0.1, 0.3, 0.45})
        for (const double poisson_b : {0.2, 0.49988})
            for (const double ratio : {1e-4, 0.03, 30.0, 5e3}) {
                const Material a = elastic(poisson_a, 1e9);
                const Material b = elastic(poisson_b, ratio * 1e9);
                EXPECT_NEAR(bogy_function(dundurs(a, b), corner_exponent(a, b)), 0.0, 1e-10)
                    << poisson_a << " " << poisson_b << " " << ratio;
            }
}

// One material rigid: a quarter plane with one face clamped, one free. Williams (1952), plane
// strain: sin^2(lambda pi/2) (3 - 4 nu) = 4 (1 - nu)^2 - lambda^2.
TEST(WilliamsCorner, TendsToAClampedQuarterPlane) {
    for (const double poisson : {0.1, 0.3, 0.49}) {
        const auto clamped = [&](double lambda) {
            return std::pow(std::sin(0.5 * pi * lambda), 2) * (3.0 - 4.0 * poisson) -
                   4.0 * std::pow(1.0 - poisson, 2) + lambda * lambda;
        };
        const double expected = bracketed_root(clamped, 0.3, 0.99);
        EXPECT_NEAR(corner_exponent(elastic(poisson, 1.0), elastic(0.3, 1e9)), expected, 1e-6);
    }
}

TEST(WilliamsCorner, DundursOfKnownPairs) {
    const Dundurs same = dundurs(ap(), ap());
    EXPECT_EQ(same.alpha, 0.0);
    EXPECT_EQ(same.beta, 0.0);
    // In plane strain alpha compares E/(1 - nu^2).
    const Dundurs pair = dundurs(elastic(0.2, 1.0), elastic(0.4, 3.0));
    const double first = 2.0 * 1.2 / (1.0 - 0.04);
    const double second = 2.0 * 1.4 * 3.0 / (1.0 - 0.16);
    EXPECT_NEAR(pair.alpha, (second - first) / (first + second), 1e-14);
}

// Under it Hooke's law, written with K and mu, strains both materials alike along the interface.
TEST(WilliamsCorner, EvenStressStrainsTheInterfaceAlike) {
    const double s = even_stress(ap(), binder(), 2e6);
    const auto strain = [&](const Material& m) {
        // Plane strain: sigma_zz = nu (sigma_xx + sigma_yy), E = 9 K mu/(3 K + mu).
        const double k = m.bulk_modulus;
        const double mu = m.shear_modulus;
        const double poisson = (3.0 * k - 2.0 * mu) / (2.0 * (3.0 * k + mu));
        const double young = 9.0 * k * mu / (3.0 * k + mu);
        return ((1.0 - poisson * poisson) * -2e6 - poisson * (1.0 + poisson) * s) / young;
    };
    // Round-off of 1 - nu - nu of the binder: K/mu = 4268 times 1e-16, and its compliance 1/mu.
    EXPECT_NEAR(strain(ap()), strain(binder()), 1e-9 * std::abs(strain(ap())));
    EXPECT_THROW(even_stress(ap(), ap(), 2e6), std::invalid_argument);
}

TEST(WilliamsCorner, RefusesByName) {
    EXPECT_THROW(corner_exponent(ap(), ap()), std::invalid_argument);
    EXPECT_THROW(corner_exponent(Material{}, ap()), std::invalid_argument);
    EXPECT_THROW(williams_determinant(ap(), binder(), -0.5), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
