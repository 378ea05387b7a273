#include "reference/manufactured_heat.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

Fields heat_fields() {
    return joined({surface_field(), scalar_field("surface_rate", "m/s", "phi_t at x"),
                   temperature_field(), scalar_field("temperature_rate", "K/s", "DT/Dt"),
                   vector_fields("velocity", "m/s", "of the material"),
                   scalar_field("velocity_divergence", "1/s", "div v"),
                   scalar_field("heat_source", "W/m^3", "q"),
                   scalar_field("surface_heat_flux", "W/m^2",
                                "kappa n . grad T at x, into the solid, per true length")});
}

HeatedSolid solid_of(const Given& given) {
    const Material m = material_of(given);
    return {.conductivity = m.thermal_conductivity,
            .capacity = m.density * m.specific_heat,
            .stress_work = given.number("stress_work"),
            .capacity_slope = given.number("capacity_slope"),
            .width = given.number("width"),
            .depth = given.number("depth"),
            .cold_temperature = given.number("cold_temperature"),
            .rise = given.number("rise"),
            .frequency = given.number("frequency"),
            .surface_wave = given.number("surface_wave"),
            .regression_rate = given.number("regression_rate"),
            .speed = given.number("speed"),
            .linear = given.text("shape") == "linear"};
}

Row row(const ManufacturedHeat& heat, double x, double y, double t) {
    const auto [u, v] = heat.velocity(x, y, t);
    return Row()
        .add(heat.surface(x, t))
        .add(heat.surface_rate(x, t))
        .add(heat.temperature(x, y, t))
        .add(heat.material_rate(x, y, t))
        .add(u)
        .add(v)
        .add(heat.divergence(x, y, t))
        .add(heat.source(x, y, t))
        .add(heat.surface_flux(x, t));
}

/// Smooth beyond its edges, and told a tenth of the depth beyond them.
Truth heat_truth(const Given& given) {
    const HeatedSolid solid = solid_of(given);
    const ManufacturedHeat heat(solid);
    const Domain around{.y = {-1.1 * solid.depth, 0.1 * solid.depth},
                        .surface = [heat](double x, double t) { return heat.surface(x, t); }};
    return pointwise(heat_fields(), around, [heat](const Eigen::Vector2d& at, double t) {
        return row(heat, at.x(), at.y(), t);
    });
}

std::vector<Parameter> heat_parameters() {
    return joined(
        material_parameters("AP", thermal_properties()),
        {number("stress_work", "Pa/K", 0.0, limits::not_negative, "beta of -beta T div v"),
         number("capacity_slope", "J/(m^3 K^2)", 0.0, limits::not_negative,
                "beta^2/K, by which rho c falls with T; zero at constant pressure"),
         number("width", "m", 240e-6, limits::positive, "period in x"),
         number("depth", "m", 240e-6, limits::positive, "from the surface to the bottom"),
         number("cold_temperature", "K", 300.0, limits::positive, "T0, at the bottom"),
         number("rise", "K", 300.0, limits::not_negative, "about as much hotter is the surface"),
         number("frequency", "rad/s", 500.0, limits::not_negative,
                "of everything that changes at a fixed depth; 0 is steady"),
         number("surface_wave", "m", 12e-6, limits::finite, "height of the wave on the surface"),
         number("regression_rate", "m/s", 0.0045, limits::finite,
                "mean speed at which the surface sinks"),
         number("speed", "m/s", 0.001, limits::finite, "of the solid"),
         text("shape", "waves", {"waves", "linear"},
              "curved everywhere, or T and v linear under a level surface")});
}

}  // namespace

TruthEntry manufactured_heat_entry() {
    return {.name = "manufactured-heat",
            .description =
                "A heated, moving, deforming solid, made up, with the heat source and "
                "the surface flux that it needs. y in the laboratory.",
            .source = "manufactured for paper eq. 7 and 34; reference/manufactured_heat.hpp",
            .parameters = heat_parameters(),
            .fields = heat_fields(),
            .examples = lattice({0.0, 200e-6}, {-200e-6, -20e-6}),
            .example_time = 1e-3,
            .build = heat_truth};
}

}  // namespace crawford::reference
