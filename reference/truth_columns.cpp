#include "reference/adiabatic_column.hpp"
#include "reference/travelling_layer.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

const std::vector<std::string> betas{"3 alpha K", "alpha K"};

double beta(const Given& given, const char* reading, const Material& m) {
    const double factor = given.text(reading) == "alpha K" ? 1.0 : 3.0;
    return factor * m.thermal_expansion * m.bulk_modulus;
}

ConfinedSolid confined_solid(const Given& given) {
    const Material m = material_of(given);
    const double work = beta(given, "stress_work", m);
    const bool constant_volume = given.text("heat_capacity") == "c_v";
    return {.capacity = m.density * m.specific_heat,
            .capacity_slope = constant_volume ? work * work / m.bulk_modulus : 0.0,
            .stress_work = work,
            .thermal_stress = beta(given, "thermal_stress", m),
            .lame = m.lame(),
            .shear_modulus = m.shear_modulus,
            .cold_temperature = given.number("cold_temperature")};
}

Fields column_fields() {
    return joined({temperature_field(), stress_fields()});
}

Truth column_truth(const Given& given) {
    const AdiabaticColumn column(confined_solid(given));
    const bool heated = given.text("load") == "heat";
    const double pressure = heated ? 0.0 : given.number("pressure");
    const double temperature =
        heated ? column.heated(given.number("heat")) : column.pressed(pressure);
    const double lateral = column.lateral_stress(temperature, pressure);
    const PlaneStrainStress stress{.xx = lateral, .yy = -pressure, .zz = lateral, .xy = 0.0};
    return pointwise(column_fields(), {}, [=](const Eigen::Vector2d&, double) {
        return Row().add(temperature).add(stress);
    });
}

Truth layer_truth(const Given& given) {
    const Material m = material_of(given);
    const double burn_rate = given.number("burn_rate");
    const TravellingLayer layer(
        {.conductivity = m.thermal_conductivity,
         .capacity = m.density * m.specific_heat,
         .regression_rate = burn_rate,
         .flux = given.number("heat_flux") + m.heat_of_reaction * m.density * burn_rate,
         .cold_temperature = given.number("cold_temperature")});
    if (given.text("state") == "steady")
        return pointwise(temperature_field(), {.y = {-given.number("depth"), 0.0}},
                         [layer, depth = given.number("depth")](const Eigen::Vector2d& at, double) {
                             return Row().add(layer.steady(at.y(), depth));
                         });
    return pointwise(temperature_field(),
                     {.y = {.to = 0.0}, .time = {.from = std::numeric_limits<double>::min()}},
                     [layer](const Eigen::Vector2d& at, double t) {
                         return Row().add(layer.heating(at.y(), t));
                     });
}

}  // namespace

TruthEntry adiabatic_column_entry() {
    return {.name = "adiabatic-column",
            .description =
                "A thermoelastic solid that cannot widen, heated or pressed uniformly "
                "without conduction: the same everywhere.",
            .source =
                "paper eq. 7, 34 and 38 without gradients, integrated once; "
                "reference/adiabatic_column.hpp",
            .parameters = joined(
                material_parameters("AP", {"specific_heat", "density", "bulk_modulus",
                                           "shear_modulus", "thermal_expansion"}),
                {text("load", "heat", {"heat", "pressure"},
                      "heated, free to rise; or pressed, without heat"),
                 number("heat", "J/m^3", 5e8, limits::not_negative, "brought, where load is heat"),
                 number("pressure", "Pa", 2e6, limits::not_negative, "where load is pressure"),
                 text("thermal_stress", "3 alpha K", betas, "beta of the stress equation"),
                 text("stress_work", "3 alpha K", betas, "beta of the heat equation"),
                 text("heat_capacity", "c_p", {"c_p", "c_v"}, "which stands before DT/Dt"),
                 number("cold_temperature", "K", 300.0, limits::positive,
                        "T0, where the solid is free of stress")}),
            .fields = column_fields(),
            .examples = lattice({0.0, 120e-6}, {-240e-6, 0.0}),
            .build = column_truth};
}

TruthEntry travelling_layer_entry() {
    auto properties = thermal_properties();
    properties.emplace_back("heat_of_reaction");
    return {
        .name = "travelling-layer",
        .description =
            "The thermal boundary layer of a rigid half space whose surface sinks at a "
            "constant rate under a constant flux, seen from the surface, y = 0: steady, "
            "or heated from a cold start.",
        .source =
            "paper eq. 7 without mechanics; on the way to the steady state the integral of "
            "Ogata and Banks (1961); reference/travelling_layer.hpp",
        .parameters = joined(
            material_parameters("AP", properties),
            {text("state", "steady", {"steady", "heating"},
                  "steady above a cold plane at -depth, or at a time > 0 after the flux has met a "
                  "cold solid"),
             number("heat_flux", "W/m^2", 200.0 * calorie_per_second_per_cm2, limits::finite,
                    "Q, from the flame; q_s rho r_b enters beside it"),
             number("burn_rate", "m/s", 0.0045, limits::positive, "r_b"),
             number("cold_temperature", "K", 300.0, limits::positive, "T0"),
             number("depth", "m", 480e-6, limits::positive, "of the cold plane, where steady")}),
        .fields = temperature_field(),
        .examples = lattice({0.0, 120e-6}, {-300e-6, 0.0}),
        .example_time = 2e-3,
        .build = layer_truth};
}

}  // namespace crawford::reference
