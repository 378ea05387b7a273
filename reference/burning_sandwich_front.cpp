#include "reference/burning_sandwich_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/front_space.hpp"
#include "reference/require.hpp"

namespace crawford::reference {
namespace {

void require_burning(const Material& material) {
    require_positive("thermal_conductivity", material.thermal_conductivity);
    require_positive("specific_heat", material.specific_heat);
    require_positive("density", material.density);
    require_positive("pyrolysis_prefactor", material.pyrolysis_prefactor);
    require_positive("activation_temperature", material.activation_temperature);
    require_finite("heat_of_reaction", material.heat_of_reaction);
}

void require_valid(const SandwichGeometry& geometry, const SandwichFlame& flame,
                   const SandwichElements& elements) {
    require_burning(geometry.inner);
    require_burning(geometry.outer);
    require_positive("inner_flux", flame.inner_flux);
    require_positive("outer_flux", flame.outer_flux);
    require_positive("cold_temperature", flame.cold_temperature);
    // Uncertainty comes from coarser elements, which have to be others.
    if (elements.degree < 3) throw std::invalid_argument("degree must be at least 3");
    if (elements.layers < 2) throw std::invalid_argument("layers must be at least 2");
}

SteadyFront solve(const SandwichGeometry& geometry, const SandwichFlame& flame,
                  const TensorSpace& space) {
    return find_steady_front(geometry, flame, SlopedHeat(geometry, flame, space));
}

TensorSpace checked_space(const SandwichGeometry& geometry, const SandwichFlame& flame,
                          const SandwichElements& elements) {
    require_valid(geometry, flame, elements);
    return front_space(geometry, elements);
}

SurfaceCurve curve_of(const SandwichGeometry& geometry, const TensorSpace& space,
                      const Eigen::VectorXd& slope) {
    const int degree = space.basis().degree();
    std::vector<double> ends;
    Eigen::MatrixXd pieces(space.elements_x(), degree + 1);
    for (int c = 0; c < space.elements_x(); ++c) {
        const auto element = space.element(c);
        const int first = c * degree + (in_strip(geometry, element) ? 0 : 1);
        pieces.row(c) = slope.segment(first, degree + 1).transpose();
        ends.push_back(element.left);
    }
    ends.push_back(geometry.half_width);
    return {ends, space.basis(), pieces};
}

SandwichElements coarser(const SandwichElements& elements) {
    return {.degree = std::max(elements.degree - 2, 2),
            .layers = std::max(elements.layers - 2, 1),
            .ratio = elements.ratio};
}

}  // namespace

SandwichFlame paper_flame() {
    return {.inner_flux = 160.0 * calorie_per_second_per_cm2,
            .outer_flux = 200.0 * calorie_per_second_per_cm2,
            .cold_temperature = 300.0};
}

BurningSandwichFront::BurningSandwichFront(const SandwichGeometry& geometry,
                                           const SandwichFlame& flame,
                                           const SandwichElements& elements)
    : geometry_(geometry),
      flame_(flame),
      space_(checked_space(geometry, flame, elements)),
      front_(solve(geometry, flame, space_)),
      curve_(curve_of(geometry, space_, front_.slope)) {
    const TensorSpace less = front_space(geometry, coarser(elements));
    uncertainty_ = std::abs(front_.rate - solve(geometry, flame, less).rate);
}

/// V is r sqrt(1 + phi_x^2): times the width it is the integral of r over the arc.
double BurningSandwichFront::mean_burn_rate() const {
    return front_.rate * geometry_.half_width / curve_.length(0.0, geometry_.half_width);
}

double BurningSandwichFront::interface_temperature() const {
    return surface_temperature(geometry_.strip);
}

double BurningSandwichFront::notch_depth() const {
    return -height(geometry_.strip);
}

void BurningSandwichFront::require_within(double x) const {
    if (!(std::abs(x) <= geometry_.half_width))
        throw std::invalid_argument(fmt::format("x = {} lies outside the sandwich", x));
}

double BurningSandwichFront::height(double x) const {
    require_within(x);
    return curve_.height(std::abs(x));
}

double BurningSandwichFront::slope(double x) const {
    require_within(x);
    return curve_.slope(std::abs(x)) * (x < 0.0 ? -1.0 : 1.0);
}

double BurningSandwichFront::surface_temperature(double x) const {
    const auto probe = space_.at(std::abs(x), 0.0);
    return probe.value.dot(front_.temperature(probe.nodes));
}

double BurningSandwichFront::temperature(double x, double y) const {
    double eta = y - height(x);
    const double rounding = 1e-12 * geometry_.depth;
    if (eta > 0.0 && eta < rounding) eta = 0.0;
    if (eta < -geometry_.depth && eta > -geometry_.depth - rounding) eta = -geometry_.depth;
    const auto probe = space_.at(std::abs(x), eta);
    return probe.value.dot(front_.temperature(probe.nodes));
}

double BurningSandwichFront::heat_in() const {
    const auto [inner, outer, strip, half_width, depth] = geometry_;
    const double burnt = inner.heat_of_reaction * inner.density * strip +
                         outer.heat_of_reaction * outer.density * (half_width - strip);
    return flame_.inner_flux * curve_.length(0.0, strip) +
           flame_.outer_flux * curve_.length(strip, half_width) + front_.rate * burnt;
}

double BurningSandwichFront::enthalpy_out() const {
    const Eigen::VectorXd mean = space_.basis().mass().rowwise().sum() / 2.0;
    double heat = 0.0;
    for (int c = 0; c < space_.elements_x(); ++c) {
        const auto element = space_.element(space_.top_element(c));
        const Material& material = material_of(geometry_, element);
        const std::vector<int> top(element.nodes.end() - mean.size(), element.nodes.end());
        const double rise = mean.dot(front_.temperature(top)) - flame_.cold_temperature;
        heat += material.density * material.specific_heat * rise * element.width;
    }
    return front_.rate * heat;
}

}  // namespace crawford::reference
