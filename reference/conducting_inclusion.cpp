#include "reference/conducting_inclusion.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

ConductingInclusion::ConductingInclusion(const DiscInHeat& disc)
    : disc_(disc), fade_(disc.whole, disc.gone) {
    require_positive("inner_conductivity", disc.inner_conductivity);
    require_positive("outer_conductivity", disc.outer_conductivity);
    require_positive("radius", disc.radius);
    require_positive("temperature", disc.temperature);
    require_finite("gradient_x", disc.gradient_x);
    require_finite("gradient_y", disc.gradient_y);
    if (disc.whole <= disc.radius)
        throw std::invalid_argument(
            fmt::format("whole = {} must be more than the radius, {}", disc.whole, disc.radius));
}

double ConductingInclusion::undiminished(double x, double y) const {
    const double inner = disc_.inner_conductivity;
    const double outer = disc_.outer_conductivity;
    const double undisturbed = disc_.gradient_x * x + disc_.gradient_y * y;
    const double square = x * x + y * y;
    if (square <= disc_.radius * disc_.radius) return 2.0 * outer / (inner + outer) * undisturbed;
    const double dipole = (inner - outer) / (inner + outer) * disc_.radius * disc_.radius;
    return (1.0 - dipole / square) * undisturbed;
}

Eigen::Vector2d ConductingInclusion::gradient_outside(double x, double y) const {
    const double inner = disc_.inner_conductivity;
    const double outer = disc_.outer_conductivity;
    const Eigen::Vector2d g(disc_.gradient_x, disc_.gradient_y);
    const Eigen::Vector2d place(x, y);
    const double square = place.squaredNorm();
    const double dipole = (inner - outer) / (inner + outer) * disc_.radius * disc_.radius;
    return (1.0 - dipole / square) * g + 2.0 * dipole * g.dot(place) / (square * square) * place;
}

double ConductingInclusion::temperature(double x, double y) const {
    return disc_.temperature + fade_.at(x, y).value * undiminished(x, y);
}

double ConductingInclusion::source(double x, double y) const {
    const Fade::Value chi = fade_.at(x, y);
    if (chi.value == 1.0) return 0.0;
    return -disc_.outer_conductivity * (2.0 * chi.gradient.dot(gradient_outside(x, y)) +
                                        undiminished(x, y) * chi.hessian.trace());
}

}  // namespace crawford::reference
