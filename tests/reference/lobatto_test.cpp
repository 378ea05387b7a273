#include "reference/lobatto.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace crawford::reference {
namespace {

TEST(Lobatto, KnownPoints) {
    EXPECT_NEAR(LobattoBasis(2).points()[1], 0.0, 1e-15);
    EXPECT_NEAR(LobattoBasis(3).points()[1], -1.0 / std::sqrt(5.0), 1e-15);
    EXPECT_NEAR(LobattoBasis(4).points()[3], std::sqrt(3.0 / 7.0), 1e-15);
}

// Interpolation of x^n is exact for n <= degree, so its derivative and integrals are known.
TEST(Lobatto, ReproducesPolynomials) {
    for (int degree = 1; degree <= 12; ++degree) {
        const LobattoBasis basis(degree);
        for (int n = 0; n <= degree; ++n) {
            const Eigen::VectorXd power = basis.points().array().pow(n);
            EXPECT_NEAR(basis.values(0.3).dot(power), std::pow(0.3, n), 1e-13);
            const double slope = n == 0 ? 0.0 : n * std::pow(0.3, n - 1);
            EXPECT_NEAR(basis.derivatives(0.3).dot(power), slope, 1e-11);
            EXPECT_NEAR(power.dot(basis.mass() * power), 2.0 / (2 * n + 1), 1e-13);
            const double bend = n == 0 ? 0.0 : 2.0 * n * n / (2 * n - 1);
            EXPECT_NEAR(power.dot(basis.stiffness() * power), bend, 1e-10);
            // integral of 1 * (x^n)' = 1 - (-1)^n
            const double rise = n % 2 == 1 ? 2.0 : 0.0;
            const Eigen::VectorXd one = Eigen::VectorXd::Ones(degree + 1);
            EXPECT_NEAR(one.dot(basis.convection() * power), rise, 1e-12);
        }
    }
}

TEST(Lobatto, GaussRuleIsExactToItsDegree) {
    for (int count = 1; count <= 12; ++count) {
        const GaussRule rule(count);
        for (int n = 0; n < 2 * count; n += 2) {
            EXPECT_NEAR(rule.weights.dot(rule.points.array().pow(n).matrix()), 2.0 / (n + 1),
                        1e-14);
        }
    }
}

TEST(Lobatto, RefusesDegreeZero) {
    EXPECT_THROW(LobattoBasis(0), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
