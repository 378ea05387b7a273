#include "cases/verify/heat/heated_laminate.hpp"

#include <cmath>

#include "cases/units.hpp"

namespace crawford {

using reference::TwoConductors;

Material conductor(double conductivity, double capacity) {
    Material material = ammonium_perchlorate();
    material.thermal_conductivity = conductivity;
    const double share = capacity / (material.density * material.specific_heat);
    material.density *= std::sqrt(share);
    material.specific_heat *= std::sqrt(share);
    return material;
}

TwoConductors propellant_in_heat() {
    const reference::Material outer = reference::ap();
    const reference::Material inner = reference::binder();
    constexpr double width = 240.0 * units::um;
    return {.inner_conductivity = inner.thermal_conductivity,
            .outer_conductivity = outer.thermal_conductivity,
            .inner_capacity = inner.density * inner.specific_heat,
            .outer_capacity = outer.density * outer.specific_heat,
            .strip = width / 4.0,
            .width = width,
            .depth = width,
            .cold_temperature = 300.0,
            .rise = 300.0,
            .frequency = 500.0 / units::s};
}

TwoConductors conductors(double conductivity, double capacity) {
    TwoConductors solid = propellant_in_heat();
    solid.inner_conductivity = conductivity * solid.outer_conductivity;
    solid.inner_capacity = capacity * solid.outer_capacity;
    return solid;
}

TwoConductors widened(TwoConductors solid, int cells) {
    solid.strip += solid.width / cells;
    return solid;
}

PrescribedHeat heated_laminate(const TwoConductors& solid, int cells) {
    const reference::ThermalLaminate truth(solid);
    PrescribedHeat heat{.scene = heated_block(ammonium_perchlorate(), cells, 1.0)};
    heat.scene.domain.nx = cells;
    heat.scene.domain.ny = cells / 2;
    heat.scene.morphology = {
        .shape = Sandwich{solid.strip},
        .materials = {conductor(solid.outer_conductivity, solid.outer_capacity),
                      conductor(solid.inner_conductivity, solid.inner_capacity)}};
    heat.scene.surface.heat_flux = {truth.outer_flux(), truth.inner_flux()};
    heat.temperature = [truth](double x, double y, double t) { return truth.temperature(x, y, t); };
    heat.sources.heat = [truth](double x, double y, double t) { return truth.source(x, y, t); };
    heat.sources.heat_flux = [truth](double x, double, double t) {
        return truth.further_flux(x, t);
    };
    return heat;
}

}  // namespace crawford
