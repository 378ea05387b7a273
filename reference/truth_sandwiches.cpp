#include <algorithm>
#include <memory>

#include "reference/elastic_sandwich.hpp"
#include "reference/thermal_sandwich.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

std::vector<Parameter> sandwich_parameters(const std::vector<std::string>& properties) {
    return joined(
        joined(material_parameters("binder", properties, "inner_"),
               material_parameters("AP", properties, "outer_")),
        {number("width", "m", 240e-6, limits::positive, "period in x"),
         number("strip", "m", 60e-6, limits::positive, "width of the inner material, below width"),
         number("depth", "m", 480e-6, limits::positive, "L; y = -L is the bottom"),
         number("degree", "1", 8.0, {.from = 2.0, .to = 16.0, .whole = true},
                "of the finite elements"),
         number("layers", "1", 6.0, {.from = 1.0, .to = 20.0, .whole = true},
                "of elements towards interface, surface and bottom"),
         number("ratio", "1", 0.3, {.from = 0.0, .to = 1.0, .open = true},
                "width of a layer over that of the one before")});
}

SandwichGeometry geometry_of(const Given& given) {
    return {.inner = material_of(given, "inner_"),
            .outer = material_of(given, "outer_"),
            .strip = 0.5 * given.number("strip"),
            .half_width = 0.5 * given.number("width"),
            .depth = given.number("depth")};
}

SandwichElements elements_of(const Given& given) {
    return {.degree = static_cast<int>(given.number("degree")),
            .layers = static_cast<int>(given.number("layers")),
            .ratio = given.number("ratio")};
}

Domain inside(const SandwichGeometry& geometry) {
    return {.x = {-geometry.half_width, geometry.half_width}, .y = {-geometry.depth, 0.0}};
}

/// A point that rounding has put beyond an edge, on it.
Eigen::Vector2d moved_inside(const SandwichGeometry& geometry, const Eigen::Vector2d& at) {
    return {std::clamp(at.x(), -geometry.half_width, geometry.half_width),
            std::clamp(at.y(), -geometry.depth, 0.0)};
}

Fields elastic_fields() {
    return joined({vector_fields("displacement", "m", "(u, v)"), stress_fields()});
}

Fields thermal_fields() {
    return joined({temperature_field(), vector_fields("heat_flux", "W/m^2", "-kappa grad T")});
}

Truth elastic_truth(const Given& given) {
    const SandwichGeometry geometry = geometry_of(given);
    const auto sandwich = std::make_shared<const ElasticSandwich>(
        geometry, given.number("pressure"),
        given.text("support") == "roller" ? Support::roller : Support::clamped, elements_of(given));
    return pointwise(elastic_fields(), inside(geometry), [=](const Eigen::Vector2d& point, double) {
        const Eigen::Vector2d at = moved_inside(geometry, point);
        return Row()
            .add(sandwich->displacement(at.x(), at.y()))
            .add(sandwich->stress(at.x(), at.y()));
    });
}

Truth thermal_truth(const Given& given) {
    const SandwichGeometry geometry = geometry_of(given);
    const auto sandwich = std::make_shared<const ThermalSandwich>(
        geometry,
        SandwichHeating{.inner_flux = given.number("inner_heat_flux"),
                        .outer_flux = given.number("outer_heat_flux"),
                        .burn_rate = given.number("burn_rate"),
                        .cold_temperature = given.number("cold_temperature")},
        elements_of(given));
    return pointwise(thermal_fields(), inside(geometry), [=](const Eigen::Vector2d& point, double) {
        const Eigen::Vector2d at = moved_inside(geometry, point);
        return Row()
            .add(sandwich->temperature(at.x(), at.y()))
            .add(sandwich->heat_flux(at.x(), at.y()));
    });
}

}  // namespace

TruthEntry elastic_sandwich_entry() {
    return {
        .name = "elastic-sandwich",
        .description =
            "A cold sandwich under a pressure on its flat surface y = 0, a strip "
            "about x = 0, plane strain. Singular where interface and surface meet.",
        .source =
            "small-strain elasticity by finite elements of high degree on a graded "
            "mesh; reference/elastic_sandwich.hpp",
        .parameters = joined(sandwich_parameters(elastic_properties()),
                             {number("pressure", "Pa", 2e6, limits::finite, "p_c on the surface"),
                              text("support", "roller", {"roller", "clamped"},
                                   "how the bottom is held: v = 0, or u = v = 0")}),
        .fields = elastic_fields(),
        .examples = lattice({-120e-6, 100e-6}, {-480e-6, 0.0}),
        .build = elastic_truth};
}

TruthEntry thermal_sandwich_entry() {
    auto properties = thermal_properties();
    properties.emplace_back("heat_of_reaction");
    return {.name = "thermal-sandwich",
            .description =
                "Steady heat in a sandwich that burns at one fixed rate, flat surface "
                "y = 0, a strip about x = 0, no mechanics.",
            .source =
                "paper eq. 7 by finite elements of high degree on a graded mesh; "
                "reference/thermal_sandwich.hpp",
            .parameters = joined(
                sandwich_parameters(properties),
                {number("inner_heat_flux", "W/m^2", paper_heating().inner_flux, limits::finite,
                        "Q into the strip"),
                 number("outer_heat_flux", "W/m^2", paper_heating().outer_flux, limits::finite,
                        "Q into the rest"),
                 number("burn_rate", "m/s", paper_heating().burn_rate, limits::positive, "r_b"),
                 number("cold_temperature", "K", paper_heating().cold_temperature, limits::positive,
                        "T0, at the bottom")}),
            .fields = thermal_fields(),
            .examples = lattice({-120e-6, 100e-6}, {-480e-6, 0.0}),
            .build = thermal_truth};
}

}  // namespace crawford::reference
