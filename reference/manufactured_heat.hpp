/// Made-up heat under a surface that moves, with its sources.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/material.hpp"

namespace crawford::reference {

/// A heated, moving, deforming solid that somebody has made up.
struct HeatedSolid {
    double conductivity = missing;  ///< kappa [W/(m K)]
    double capacity = missing;      ///< rho c_p [J/(m^3 K)]
    double stress_work = 0.0;       ///< beta of -beta T div v [Pa/K]
    /// beta^2/K [J/(m^3 K^2)], by which the capacity falls with T where it is taken at constant
    /// volume, rho c_v = rho c_p - beta^2 T/K; zero at constant pressure.
    double capacity_slope = 0.0;

    double width = missing;             ///< period in x [m]
    double depth = missing;             ///< from the surface to the bottom [m]
    double cold_temperature = missing;  ///< T0, at the bottom [K]
    double rise = missing;              ///< about as much hotter is the surface [K]
    double frequency = 0.0;  ///< of everything that changes at a fixed depth [rad/s]; 0 is steady
    double surface_wave = 0.0;     ///< height of the wave on the surface [m]
    double regression_rate = 0.0;  ///< mean speed at which the surface sinks [m/s]
    double speed = 0.0;            ///< of the solid [m/s]
    /// Neither T nor v curves and the surface is level: bilinear elements carry them without error,
    /// and what is left is the error in time.
    bool linear = false;
};

/// Temperature, surface and velocity chosen at will, and the source and the surface flux with which
/// they satisfy
///
///     (rho c_p - beta^2 T/K) (T_t + v . grad T) = kappa div grad T - beta T div v + q
///     kappa n . grad T = flux on y = phi(x, t),   T = T0 on y = phi - depth.
///
/// The fields are templates of their scalars; every derivative is taken of them by automatic
/// differentiation, and none is written down by hand. One variable at a time: kappa is constant, so
/// no mixed derivative enters.
class ManufacturedHeat {
public:
    /// \throws std::invalid_argument naming the missing or out-of-range parameter.
    explicit ManufacturedHeat(const HeatedSolid& solid);

    /// phi [m]
    template <class X, class T>
    auto surface(const X& x, const T& t) const;
    /// T [K] at a height y [m] of the laboratory.
    template <class X, class Y, class T>
    auto temperature(const X& x, const Y& y, const T& t) const;
    /// (u, v) [m/s]
    template <class X, class Y, class T>
    auto velocity(const X& x, const Y& y, const T& t) const;

    double surface_rate(double x, double t) const;             ///< phi_t [m/s]
    double divergence(double x, double y, double t) const;     ///< div v [1/s]
    double material_rate(double x, double y, double t) const;  ///< DT/Dt [K/s]
    double source(double x, double y, double t) const;         ///< q [W/m^3]
    /// kappa n . grad T [W/m^2] into the solid, per unit of the surface's true length.
    double surface_flux(double x, double t) const;

private:
    /// What an expression of all of them is.
    template <class... Scalars>
    using Common = decltype((std::declval<Scalars>() + ...));

    struct Derivatives {
        double x, y, t, laplacian;
    };
    Derivatives derivatives_of_temperature(double x, double y, double t) const;

    /// Height above the bottom, 0 there and 1 at the surface.
    template <class X, class Y, class T>
    auto height(const X& x, const Y& y, const T& t) const {
        return Common<X, Y, T>(1.0 + (y - surface(x, t)) / solid_.depth);
    }
    /// A change in time that starts at zero, with rate one.
    template <class T>
    T swing(const T& t) const {
        using std::sin;
        if (solid_.frequency > 0.0) return sin(solid_.frequency * t) / solid_.frequency;
        return t;
    }
    double wave_number() const { return 2.0 * std::numbers::pi / solid_.width; }

    HeatedSolid solid_;
};

template <class X, class T>
auto ManufacturedHeat::surface(const X& x, const T& t) const {
    using std::cos, std::sin;
    using Scalar = Common<X, T>;
    const double sinks = solid_.regression_rate;
    if (solid_.linear) return Scalar(-sinks * (t + 0.5 * swing(t)) + 0.0 * x);
    const auto kx = wave_number() * x;
    const Scalar steady = solid_.surface_wave * sin(kx) - sinks * t;
    if (solid_.frequency == 0.0) return steady;
    return Scalar(steady - 0.5 * sinks * swing(t) * cos(kx));
}

template <class X, class Y, class T>
auto ManufacturedHeat::temperature(const X& x, const Y& y, const T& t) const {
    using std::cos, std::exp, std::sin;
    using Scalar = Common<X, Y, T>;
    const auto z = height(x, y, t);
    const auto phase = solid_.frequency * t;
    const auto risen = solid_.rise * z;
    if (solid_.linear) return Scalar(solid_.cold_temperature + risen * (1.0 + 0.3 * sin(phase)));
    const auto kx = wave_number() * x;
    const auto across = 1.0 + 0.3 * sin(kx + phase) + 0.2 * (1.0 - z) * cos(kx) * cos(phase);
    return Scalar(solid_.cold_temperature + risen * exp(z - 1.0) * across);
}

template <class X, class Y, class T>
auto ManufacturedHeat::velocity(const X& x, const Y& y, const T& t) const {
    using std::cos, std::sin;
    using Scalar = Common<X, Y, T>;
    const auto z = height(x, y, t);
    const auto pulse = 1.0 + 0.5 * sin(solid_.frequency * t);
    if (solid_.linear)
        return std::array<Scalar, 2>{Scalar(0.0 * z),
                                     Scalar(solid_.speed * (0.5 + 0.5 * z) * pulse)};
    const auto kx = wave_number() * x;
    return std::array<Scalar, 2>{Scalar(0.5 * solid_.speed * sin(kx + 0.4) * (z + z * z) * pulse),
                                 Scalar(solid_.speed * z * (pulse + 0.3 * cos(kx) + z))};
}

}  // namespace crawford::reference
