#include "reference/lobatto.hpp"

#include <boost/math/special_functions/legendre.hpp>
#include <stdexcept>

#include "reference/root.hpp"

namespace crawford::reference {
namespace {

/// Ends and extrema of the Legendre polynomial: its derivative vanishes once between neighbouring
/// zeros.
Eigen::VectorXd lobatto_points(int degree) {
    Eigen::VectorXd points(degree + 1);
    points[0] = -1.0;
    points[degree] = 1.0;
    const Eigen::VectorXd zeros = GaussRule(degree).points;
    const auto derivative = [&](double x) { return boost::math::legendre_p_prime(degree, x); };
    for (int i = 1; i < degree; ++i) {
        points[i] = bracketed_root(derivative, zeros[i - 1], zeros[i]);
    }
    return points;
}

}  // namespace

GaussRule::GaussRule(int count) : points(count), weights(count) {
    // Boost lists the zeros that are not negative, ascending.
    const auto half = boost::math::legendre_p_zeros<double>(count);
    for (int i = 0; i < static_cast<int>(half.size()); ++i) {
        const double zero = half[half.size() - 1 - static_cast<std::size_t>(i)];
        points[i] = -zero;
        points[count - 1 - i] = zero;
    }
    for (int i = 0; i < count; ++i) {
        const double slope = boost::math::legendre_p_prime(count, points[i]);
        weights[i] = 2.0 / ((1.0 - points[i] * points[i]) * slope * slope);
    }
}

LobattoBasis::LobattoBasis(int degree) : degree_(degree) {
    if (degree < 1) throw std::invalid_argument("degree must be at least 1");
    points_ = lobatto_points(degree);
    mass_ = stiffness_ = convection_ = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
    const GaussRule rule(degree + 1);
    for (int q = 0; q <= degree; ++q) {
        const Eigen::VectorXd phi = values(rule.points[q]);
        const Eigen::VectorXd slope = derivatives(rule.points[q]);
        mass_ += rule.weights[q] * phi * phi.transpose();
        stiffness_ += rule.weights[q] * slope * slope.transpose();
        convection_ += rule.weights[q] * phi * slope.transpose();
    }
}

Eigen::VectorXd LobattoBasis::values(double xi) const {
    Eigen::VectorXd phi = Eigen::VectorXd::Ones(degree_ + 1);
    for (int i = 0; i <= degree_; ++i) {
        for (int k = 0; k <= degree_; ++k) {
            if (k != i) phi[i] *= (xi - points_[k]) / (points_[i] - points_[k]);
        }
    }
    return phi;
}

Eigen::VectorXd LobattoBasis::derivatives(double xi) const {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(degree_ + 1);
    for (int i = 0; i <= degree_; ++i) {
        for (int skipped = 0; skipped <= degree_; ++skipped) {
            if (skipped == i) continue;
            double product = 1.0 / (points_[i] - points_[skipped]);
            for (int k = 0; k <= degree_; ++k) {
                if (k != i && k != skipped)
                    product *= (xi - points_[k]) / (points_[i] - points_[k]);
            }
            slope[i] += product;
        }
    }
    return slope;
}

}  // namespace crawford::reference
