#include <cmath>

#include "reference/thermal_laminate.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

Fields laminate_fields() {
    return joined(
        {temperature_field(), scalar_field("heat_source", "W/m^3", "q"),
         scalar_field("surface_heat_flux", "W/m^2", "what enters through the surface at x"),
         scalar_field("surface_heat_flux_further", "W/m^2",
                      "what of it is beside kappa rise/depth, continuous in x"),
         scalar_field("interface_heat_flux", "W/m^2",
                      "kappa dT/dx through the interface at x = strip/2, at this height")});
}

TwoConductors conductors(const Given& given) {
    const Material inner = material_of(given, "inner_");
    const Material outer = material_of(given, "outer_");
    return {.inner_conductivity = inner.thermal_conductivity,
            .outer_conductivity = outer.thermal_conductivity,
            .inner_capacity = inner.density * inner.specific_heat,
            .outer_capacity = outer.density * outer.specific_heat,
            .strip = given.number("strip"),
            .width = given.number("width"),
            .depth = given.number("depth"),
            .cold_temperature = given.number("cold_temperature"),
            .rise = given.number("rise"),
            .frequency = given.number("frequency")};
}

Truth laminate_truth(const Given& given) {
    const TwoConductors solid = conductors(given);
    const ThermalLaminate laminate(solid);
    return pointwise(laminate_fields(), {.y = {-solid.depth, 0.0}},
                     [laminate, solid](const Eigen::Vector2d& at, double t) {
                         const double from_axis = std::abs(std::remainder(at.x(), solid.width));
                         const double even = from_axis < 0.5 * solid.strip ? laminate.inner_flux()
                                                                           : laminate.outer_flux();
                         const double further = laminate.further_flux(at.x(), t);
                         return Row()
                             .add(laminate.temperature(at.x(), at.y(), t))
                             .add(laminate.source(at.x(), at.y(), t))
                             .add(even + further)
                             .add(further)
                             .add(laminate.crossing_heat(at.y(), t));
                     });
}

}  // namespace

TruthEntry thermal_laminate_entry() {
    return {.name = "thermal-laminate",
            .description =
                "Heat that crosses the interfaces of a strip about x = 0 and swings in "
                "time, with the source that it needs; periodic in x, level surface y = 0.",
            .source =
                "manufactured for paper eq. 7 at rest, exact at the interfaces; "
                "reference/thermal_laminate.hpp",
            .parameters = joined(
                joined(material_parameters("binder", thermal_properties(), "inner_"),
                       material_parameters("AP", thermal_properties(), "outer_")),
                {number("width", "m", 240e-6, limits::positive, "period in x"),
                 number("strip", "m", 60e-6, limits::positive, "below width"),
                 number("depth", "m", 240e-6, limits::positive, "L; y = -L is cold"),
                 number("cold_temperature", "K", 300.0, limits::positive, "T0, at the bottom"),
                 number("rise", "K", 300.0, limits::positive,
                        "A: the surface over the bottom at the interfaces"),
                 number("frequency", "rad/s", 500.0, limits::not_negative, "omega; 0 is steady")}),
            .fields = laminate_fields(),
            .examples = lattice({-120e-6, 100e-6}, {-240e-6, 0.0}),
            .example_time = 1e-3,
            .build = laminate_truth};
}

}  // namespace crawford::reference
