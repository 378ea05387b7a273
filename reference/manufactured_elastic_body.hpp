/// Smooth displacements of a body below a wavy surface, to manufacture loads from. Every one is
/// periodic in x with the body's width and holds its bottom, y = surface(x) - depth, as a support
/// does.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "reference/manufactured_elasticity.hpp"

namespace crawford::reference {

/// Where the body lies: y = height cos(k x + phase) above, k = 2 pi/width, and as much lower below.
/// Without phase, body and displacements are symmetric about x = 0 and x = width/2.
struct WavyBody {
    double width = missing;   ///< one period [m]
    double depth = missing;   ///< [m]
    double height = missing;  ///< of the waves, 0 for a flat surface [m]
    double phase = missing;

    /// \throws std::invalid_argument naming the parameter that is missing or out of range.
    void require() const;

    template <class T>
    T angle(const T& x) const {
        return 2.0 * std::numbers::pi / width * x + phase;
    }
    template <class T>
    T surface(const T& x) const {  ///< [m]
        using std::cos;
        return height * cos(angle(x));
    }
    template <class T>
    T slope(const T& x) const {
        using std::sin;
        return -2.0 * std::numbers::pi / width * height * sin(angle(x));
    }
};

/// What all of them wave like: two harmonics along x that change with the height z, 0 at the bottom
/// and 1 at the surface.
template <class T>
std::array<T, 2> waves(const T& angle, const T& z) {
    using std::cos;
    using std::exp;
    using std::sin;
    return {sin(angle) * (1.0 + z) + 0.3 * sin(2.0 * angle) * cos(3.0 * z),
            0.4 + cos(angle) * exp(-z) + 0.2 * cos(2.0 * angle) * sin(2.0 * z)};
}

/// Clamped: u = v = 0 at the bottom. Nothing particular at the surface: a traction must hold it.
struct ClampedWaves {
    WavyBody body;
    double amplitude;  ///< [m]

    template <class T>
    std::array<T, 2> operator()(const T& x, const T& y) const {
        const T z = 1.0 + (y - body.surface(x)) / body.depth;
        const auto [u, v] = waves(body.angle(x), z);
        return {amplitude * z * u, amplitude * z * v};
    }
};

/// On rollers: v = 0 at the bottom, u = 0 at x = 0 only. The sideways traction of the bottom is
/// that of `pressure` on its slope and nothing else, as of a body that is pressed all around:
/// sigma_11 phi_x - sigma_12 = -pressure phi_x. The surface needs a traction.
struct RollingWaves {
    WavyBody body;
    ElasticModuli moduli;
    double amplitude;       ///< [m]
    double pressure = 0.0;  ///< [Pa]

    template <class T>
    std::array<T, 2> operator()(const T& x, const T& y) const {
        using std::cos;
        using std::sin;
        const T above = y - body.surface(x) + body.depth;
        const T z = above / body.depth;
        const T slope = body.slope(x);
        // u = slide + above shear and v = above stretch have the traction wanted where above = 0;
        // the waves, with z^2, change nothing there.
        const double stretch = amplitude / body.depth;
        const double confined = moduli.lame() + 2.0 * moduli.shear;
        const T slide = amplitude * (sin(body.angle(x)) - std::sin(body.phase));
        const T slide_x = 2.0 * std::numbers::pi / body.width * amplitude * cos(body.angle(x));
        const T shear = slope *
                        (confined * slide_x + (moduli.lame() + moduli.shear) * stretch + pressure) /
                        (moduli.shear + confined * slope * slope);
        const auto [u, v] = waves(body.angle(x), z);
        return {slide + above * shear + amplitude * z * z * u,
                above * stretch + amplitude * z * z * v};
    }
};

/// What acts on the surface [Pa] per unit x, along (-phi_x, 1) and along y.
struct SurfaceLoad {
    double normal, vertical;
};

/// Clamped, and in equilibrium with `load` on the surface, with no other traction: near it the
/// displacement is surface_waves + eta rise, eta = y - phi, rise chosen for sigma (-phi_x, 1) =
/// load.
struct PressedWaves {
    WavyBody body;
    ElasticModuli moduli;
    double amplitude;  ///< [m]
    SurfaceLoad load;

    template <class T>
    std::array<T, 2> operator()(const T& x, const T& y) const {
        using std::cos;
        using std::sin;
        const T eta = y - body.surface(x);
        const T angle = body.angle(x);
        const double k = 2.0 * std::numbers::pi / body.width;
        const auto [rise_u, rise_v] = rise(body.slope(x), T(amplitude * k * cos(angle)),
                                           T(-2.0 * amplitude * k * sin(2.0 * angle)));
        // One, and no slope, at the surface; zero at the bottom.
        const T fade = cos(std::numbers::pi / 2.0 / body.depth * eta);
        return {fade * (amplitude * sin(angle) + eta * rise_u),
                fade * (amplitude * cos(2.0 * angle) + eta * rise_v)};
    }

private:
    /// With grad = (u_x, v_x)|eta x e_1 + rise x N, N = (-phi_x, 1), the traction is
    /// C:((u_x, v_x) x e_1) N + A rise, A = mu N.N I + (lambda + mu) N N^T; solved for rise.
    template <class T>
    std::array<T, 2> rise(const T& slope, const T& u_x, const T& v_x) const {
        const double mu = moduli.shear;
        const double both = moduli.lame() + mu;
        const T right_x = -slope * load.normal + ((both + mu) * u_x * slope - mu * v_x);
        const T right_y = T(load.normal + load.vertical) + (mu * v_x * slope - moduli.lame() * u_x);
        const T norm = 1.0 + slope * slope;
        const T along = (right_y - slope * right_x) * both / ((mu + both) * norm);
        return {(right_x + slope * along) / (mu * norm), (right_y - along) / (mu * norm)};
    }
};

}  // namespace crawford::reference
