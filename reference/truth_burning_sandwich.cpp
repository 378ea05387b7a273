#include <memory>

#include "reference/burning_sandwich_front.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

std::vector<std::string> burning_properties() {
    auto properties = thermal_properties();
    for (const char* name : {"pyrolysis_prefactor", "activation_temperature", "heat_of_reaction"})
        properties.emplace_back(name);
    return properties;
}

std::vector<Parameter> sandwich_parameters() {
    const SandwichFlame flame = paper_flame();
    return joined(
        joined(material_parameters("binder", burning_properties(), "inner_"),
               material_parameters("AP", burning_properties(), "outer_")),
        {number("width", "m", 240e-6, limits::positive, "period in x"),
         number("strip", "m", 60e-6, limits::positive, "width of the inner material, below width"),
         number("depth", "m", 480e-6, limits::positive, "of the bottom below the surface"),
         number("inner_heat_flux", "W/m^2", flame.inner_flux, limits::positive, "Q into the strip"),
         number("outer_heat_flux", "W/m^2", flame.outer_flux, limits::positive, "Q into the rest"),
         number("cold_temperature", "K", flame.cold_temperature, limits::positive,
                "T0, at the bottom"),
         number("degree", "1", front_elements.degree, {.from = 3.0, .to = 12.0, .whole = true},
                "of the finite elements"),
         number("layers", "1", front_elements.layers, {.from = 2.0, .to = 20.0, .whole = true},
                "of elements towards interface and surface"),
         number("ratio", "1", front_elements.ratio, {.from = 0.0, .to = 1.0, .open = true},
                "width of a layer over that of the one before")});
}

BurningSandwichFront front_of(const Given& given) {
    return {{.inner = material_of(given, "inner_"),
             .outer = material_of(given, "outer_"),
             .strip = 0.5 * given.number("strip"),
             .half_width = 0.5 * given.number("width"),
             .depth = given.number("depth")},
            {.inner_flux = given.number("inner_heat_flux"),
             .outer_flux = given.number("outer_heat_flux"),
             .cold_temperature = given.number("cold_temperature")},
            {.degree = static_cast<int>(given.number("degree")),
             .layers = static_cast<int>(given.number("layers")),
             .ratio = given.number("ratio")}};
}

Fields sandwich_fields() {
    return joined(
        {temperature_field(), surface_field(), scalar_field("surface_slope", "1", "phi_x"),
         scalar_field("surface_temperature", "K", "T_s at that x"),
         scalar_field("regression_rate", "m/s", "V, of the front as a whole"),
         scalar_field("regression_rate_uncertainty", "m/s", "from two meshes"),
         scalar_field("mean_burn_rate", "m/s", "mean of r_b over the arc"),
         scalar_field("interface_temperature", "K", "T_s where interface and surface meet"),
         scalar_field("notch_depth", "m", "of that place below the sides")});
}

Truth sandwich_truth(const Given& given) {
    const auto front = std::make_shared<const BurningSandwichFront>(front_of(given));
    const double half_width = 0.5 * given.number("width");
    const Domain inside{.x = {-half_width, half_width},
                        .y = {-given.number("depth"), 0.0},
                        .surface = [front](double x, double) { return front->height(x); }};
    return pointwise(sandwich_fields(), inside, [front](const Eigen::Vector2d& at, double) {
        return Row()
            .add(front->temperature(at.x(), at.y()))
            .add(front->height(at.x()))
            .add(front->slope(at.x()))
            .add(front->surface_temperature(at.x()))
            .add(front->regression_rate())
            .add(front->regression_rate_uncertainty())
            .add(front->mean_burn_rate())
            .add(front->interface_temperature())
            .add(front->notch_depth());
    });
}

}  // namespace

TruthEntry burning_sandwich_front_entry() {
    return {.name = "burning-sandwich-front",
            .description =
                "A rigid sandwich that burns steadily by the burning law, a strip of the slower "
                "material about x = 0: surface, its speed and the heat below, found together; "
                "surface = 0 at the sides. Singular where interface and surface meet.",
            .source =
                "paper eq. 7 and 9 as a free-boundary problem, by finite elements of high degree "
                "on a graded mesh; reference/burning_sandwich_front.hpp",
            .parameters = sandwich_parameters(),
            .fields = sandwich_fields(),
            .examples = lattice({-120e-6, 100e-6}, {-400e-6, -15e-6}),
            .build = sandwich_truth};
}

}  // namespace crawford::reference
