#include "reference/manufactured_elastic_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

namespace {

/// A function of place and its derivative along x.
template <class T>
struct WithSlope {
    T value, slope;
};

/// Three functions of the distance s from the middle of a material of half width a, odd in s, and
/// their derivatives. At s = a one of value, first and second derivative is one, the others zero.
template <class T>
class OddBasis {
public:
    OddBasis(double half_width, const T& s)
        : quarter_(std::numbers::pi / 2.0 / half_width),
          first_(wave(1, s)),
          second_(wave(2, s)),
          third_(wave(3, s)) {}

    WithSlope<T> value() const { return sum(9.0 / 8.0, 1.0 / 8.0); }
    WithSlope<T> slope() const {
        const double factor = -1.0 / (2.0 * quarter_);
        return {factor * second_.value, factor * second_.slope};
    }
    WithSlope<T> curvature() const {
        const double factor = 1.0 / (8.0 * quarter_ * quarter_);
        return sum(factor, factor);
    }

private:
    WithSlope<T> wave(int quarters, const T& s) const {
        using std::cos;
        using std::sin;
        const double k = quarters * quarter_;
        return {sin(k * s), k * cos(k * s)};
    }
    WithSlope<T> sum(double first, double third) const {
        return {first * first_.value + third * third_.value,
                first * first_.slope + third * third_.slope};
    }

    double quarter_;  // wave number of a wave that is a quarter long at s = a [1/m]
    WithSlope<T> first_, second_, third_;
};

/// a z^n + b z^(n+1), z = 1 + y/depth, and its derivatives in y: zero at the bottom below order n.
struct AlongFace {
    double depth;
    int exponent;
    double a, b;

    template <class T>
    T derivative(int order, const T& y) const {
        const T z = 1.0 + y / depth;
        return a * power(exponent, order, z) + b * power(exponent + 1, order, z);
    }

private:
    template <class T>
    T power(int n, int order, const T& z) const {
        T result = T(1.0);
        for (int k = 0; k < n - order; ++k) result *= z;
        for (int k = 0; k < order; ++k) result *= (n - k) / depth;
        return result;
    }
};

/// What both materials share at the face, as functions of y.
struct FaceState {
    AlongFace p0, p1;         // P0 [m^2], P1 [m]
    AlongFace normal, shear;  // sigma, tau [Pa]
};

/// The displacement in one material.
struct StripSide {
    ElasticModuli moduli;
    double half_width;
    double middle;   // of the material [m]
    double outward;  // 1 where x grows from the middle to the face, else -1
    FaceState face;

    template <class T>
    std::array<T, 2> operator()(const T& x, const T& y) const {
        const OddBasis<T> odd(half_width, outward * (x - middle));
        const auto [value, value_s] = odd.value();
        const auto [slope, slope_s] = odd.slope();
        const auto [curvature, curvature_s] = odd.curvature();
        const double mu = moduli.shear;
        const T p1_y = face.p1.derivative(1, y);
        const auto bend = [&](int order) {
            return T(face.p0.derivative(2 + order, y) - face.shear.derivative(order, y) / mu);
        };
        const T squeeze =
            (face.normal.derivative(0, y) - 2.0 * mu * p1_y) / (moduli.lame() + 2.0 * mu);
        return {face.p0.derivative(1, y) * value + outward * (p1_y + squeeze) * slope +
                    bend(1) * curvature,
                -outward * (face.p0.derivative(0, y) * value_s + bend(0) * curvature_s) -
                    face.p1.derivative(0, y) * slope_s};
    }
};

FaceState face_state(const ElasticStrip& strip) {
    const double strain = strip.stress / std::max(strip.outer.shear, strip.inner.shear);
    const double l = strip.depth;
    // The bottom is clamped where P0''', P1', sigma and tau' are zero.
    return {.p0 = {l, 4, 0.3 * strain * l * l, -0.2 * strain * l * l},
            .p1 = {l, 2, -0.4 * strain * l, 0.5 * strain * l},
            .normal = {l, 2, -2.0 * strip.stress, 1.0 * strip.stress},
            .shear = {l, 2, 1.5 * strip.stress, -1.0 * strip.stress}};
}

const ElasticStrip& checked(const ElasticStrip& strip) {
    strip.require();
    return strip;
}

PlaneStrainStress mean(const PlaneStrainStress& a, const PlaneStrainStress& b) {
    return {.xx = 0.5 * (a.xx + b.xx),
            .yy = 0.5 * (a.yy + b.yy),
            .zz = 0.5 * (a.zz + b.zz),
            .xy = 0.5 * (a.xy + b.xy)};
}

Eigen::Vector2d mean(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return 0.5 * (a + b);
}

}  // namespace

void ElasticStrip::require() const {
    require_positive("width", width);
    require_positive("strip", strip);
    require_positive("depth", depth);
    require_positive("stress", stress);
    outer.require();
    inner.require();
    if (strip >= width)
        throw std::invalid_argument(
            fmt::format("strip = {} must be narrower than width = {}", strip, width));
}

ManufacturedStrip::ManufacturedStrip(const ElasticStrip& strip)
    : width_(checked(strip).width),
      face_(0.5 * strip.strip),
      outer_(StripSide{.moduli = strip.outer,
                       .half_width = 0.5 * (strip.width - strip.strip),
                       .middle = 0.5 * strip.width,
                       .outward = -1.0,
                       .face = face_state(strip)},
             strip.outer),
      inner_(StripSide{.moduli = strip.inner,
                       .half_width = 0.5 * strip.strip,
                       .middle = 0.0,
                       .outward = 1.0,
                       .face = face_state(strip)},
             strip.inner) {}

ManufacturedStrip::Folded ManufacturedStrip::fold(double x) const {
    const double within = std::remainder(x, width_);
    return {std::abs(within), within < 0.0 ? -1.0 : 1.0};
}

template <class Of>
auto ManufacturedStrip::side(double x, const Of& of) const {
    constexpr double round_off = 1e-12;
    if (std::abs(x - face_) < round_off * width_) return mean(of(inner_), of(outer_));
    return of(x < face_ ? inner_ : outer_);
}

Eigen::Vector2d ManufacturedStrip::displacement(double x, double y) const {
    const auto [folded, sign] = fold(x);
    const Eigen::Vector2d u = (folded < face_ ? inner_ : outer_).displacement(folded, y);
    return {sign * u.x(), u.y()};
}

PlaneStrainStress ManufacturedStrip::stress(double x, double y) const {
    const auto [folded, sign] = fold(x);
    PlaneStrainStress sigma = side(folded, [&, across = folded](const ManufacturedElasticity& m) {
        return m.stress(across, y);
    });
    sigma.xy *= sign;
    return sigma;
}

Eigen::Vector2d ManufacturedStrip::body_force(double x, double y) const {
    const auto [folded, sign] = fold(x);
    const Eigen::Vector2d b = side(folded, [&, across = folded](const ManufacturedElasticity& m) {
        return m.body_force(across, y);
    });
    return {sign * b.x(), b.y()};
}

}  // namespace crawford::reference
