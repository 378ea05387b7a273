#include "reference/thermal_sandwich.hpp"

#include <cmath>

#include "reference/condensed_system.hpp"
#include "reference/require.hpp"

namespace crawford::reference {
namespace {

/// Integral of kappa grad w . grad T + rho c_p r_b w dT/dy over a rectangle, from one-dimensional
/// integrals.
Eigen::MatrixXd transport(const LobattoBasis& basis, const TensorSpace::Element& element,
                          const Material& material, double burn_rate) {
    const auto& mass = basis.mass();
    const auto& bend = basis.stiffness();
    const double across = element.height / element.width;
    const double carried =
        material.density * material.specific_heat * burn_rate * element.width / 2.0;
    const int n = basis.degree() + 1;
    Eigen::MatrixXd k(n * n, n * n);
    for (int a = 0; a < n * n; ++a) {
        for (int b = 0; b < n * n; ++b) {
            const int i = a % n, j = a / n, m = b % n, l = b / n;
            k(a, b) = material.thermal_conductivity *
                          (across * bend(i, m) * mass(j, l) + mass(i, m) * bend(j, l) / across) +
                      carried * mass(i, m) * basis.convection()(j, l);
        }
    }
    return k;
}

void require_conducting(const Material& material) {
    require_positive("thermal_conductivity", material.thermal_conductivity);
    require_positive("specific_heat", material.specific_heat);
    require_positive("density", material.density);
    require_finite("heat_of_reaction", material.heat_of_reaction);
}

}  // namespace

SandwichHeating paper_heating() {
    return {.inner_flux = 160.0 * calorie_per_second_per_cm2,
            .outer_flux = 200.0 * calorie_per_second_per_cm2,
            .burn_rate = 0.0045,
            .cold_temperature = 300.0};
}

ThermalSandwich::ThermalSandwich(const SandwichGeometry& geometry, const SandwichHeating& heating,
                                 const SandwichElements& elements)
    : geometry_(geometry), heating_(heating), space_(sandwich_space(geometry, elements)) {
    require_conducting(geometry.inner);
    require_conducting(geometry.outer);
    require_finite("inner_flux", heating.inner_flux);
    require_finite("outer_flux", heating.outer_flux);
    require_positive("burn_rate", heating.burn_rate);
    require_positive("cold_temperature", heating.cold_temperature);
    assemble_and_solve();
}

/// Q + q_s rho r_b [W/m^2] of the material below an element of the surface.
double ThermalSandwich::entering(const TensorSpace::Element& element) const {
    const Material& material = material_of(geometry_, element);
    return (in_strip(geometry_, element) ? heating_.inner_flux : heating_.outer_flux) +
           material.heat_of_reaction * material.density * heating_.burn_rate;
}

void ThermalSandwich::assemble_and_solve() {
    const LobattoBasis& basis = space_.basis();
    const int n = basis.degree() + 1;
    CondensedSystem system(space_, 1);
    for (int e = 0; e < space_.elements(); ++e) {
        const auto element = space_.element(e);
        Eigen::VectorXd heat = Eigen::VectorXd::Zero(n * n);
        if (e >= space_.top_element(0)) {
            heat.tail(n) = entering(element) * basis.mass().rowwise().sum() * element.width / 2.0;
        }
        system.add(e,
                   transport(basis, element, material_of(geometry_, element), heating_.burn_rate),
                   heat);
    }
    for (int column = 0; column < space_.columns(); ++column) {
        system.hold(space_.node(column, 0), 0, heating_.cold_temperature);
    }
    temperature_ = system.solve();
}

double ThermalSandwich::temperature(double x, double y) const {
    const auto probe = space_.at(std::abs(x), y);
    return probe.value.dot(temperature_(probe.nodes));
}

Eigen::Vector2d ThermalSandwich::heat_flux(double x, double y) const {
    const auto probe = space_.at(std::abs(x), y);
    const Eigen::VectorXd nodal = temperature_(probe.nodes);
    const Eigen::Vector2d gradient(probe.dx.dot(nodal) * (x < 0.0 ? -1.0 : 1.0),
                                   probe.dy.dot(nodal));
    const Material& material = material_of(geometry_, space_.element(probe.element));
    return -material.thermal_conductivity * gradient;
}

}  // namespace crawford::reference
