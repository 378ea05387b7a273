#include "reference/manufactured_burning.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

/// Smooth beyond its edges: a tenth of the depth more is told, so that a surface found by somebody
/// else, who is off by an error, has values too.
Domain around(const ManufacturedBurning& solid, double depth) {
    return {.y = {-1.1 * depth, 0.1 * depth},
            .surface = [solid](double x, double t) { return solid.surface(x, t); }};
}

Fields burning_fields() {
    const auto source = [](const char* suffix) {
        return scalar_field(std::string("stress_source_") + suffix, "Pa/s", "S");
    };
    return joined({surface_field(), temperature_field(),
                   scalar_field("temperature_rate", "K/s", "DT/Dt"), motion_fields(),
                   matrix_fields("velocity_gradient", "1/s", "dv_i/dx_j"), stress_fields(),
                   scalar_field("heat_source", "W/m^3", "q"), source("xx"), source("yy"),
                   source("zz"), source("xy"), vector_fields("body_force", "N/m^3", "b"),
                   scalar_field("surface_heat_flux", "W/m^2", "at x, beside Q_g + q_s rho r_b"),
                   vector_fields("surface_traction", "Pa", "at x, beside -p_c n")});
}

Row row(const ManufacturedBurning& solid, const Eigen::Vector2d& at, double t) {
    const double x = at.x();
    const double y = at.y();
    const Eigen::Vector2d shift = solid.shift(x, y, t);
    const PlaneStrainStress stress = solid.stress(x, y, t);
    const PlaneStrainStress source = solid.stress_source(x, y, t);
    return Row()
        .add(solid.surface(x, t))
        .add(solid.temperature(x, y, t))
        .add(solid.temperature_rate(x, y, t))
        .add(solid.velocity(x, y, t))
        .add(Eigen::Vector2d(at + shift))
        .add(Eigen::Vector2d(-shift))
        .add(solid.deformation_gradient(x, y, t))
        .add(solid.velocity_gradient(x, y, t))
        .add(stress)
        .add(solid.heat_source(x, y, t))
        .add(source.xx)
        .add(source.yy)
        .add(source.zz)
        .add(source.xy)
        .add(solid.body_force(x, y, t))
        .add(solid.heat_flux(x, t))
        .add(solid.traction(x, t));
}

BurningParameters parameters_of(const Given& given) {
    return {.material = material_of(given),
            .width = given.number("width"),
            .depth = given.number("depth"),
            .regression_rate = given.number("regression_rate"),
            .wave_height = given.number("wave_height"),
            .wave_frequency = given.number("wave_frequency"),
            .bottom_temperature = given.number("bottom_temperature"),
            .displacement = given.number("displacement"),
            .motion_frequency = given.number("motion_frequency"),
            .stress = given.number("stress"),
            .gas_pressure = given.number("pressure"),
            .gas_flux = given.number("heat_flux")};
}

std::vector<Parameter> burning_parameters() {
    return joined(
        material_parameters("AP", all_properties()),
        {number("width", "m", 240e-6, limits::positive, "period in x"),
         number("depth", "m", 240e-6, limits::positive, "of the window below the surface"),
         number("regression_rate", "m/s", 0.0045, limits::positive, "of the mean surface"),
         number("wave_height", "m", 6e-6, limits::not_negative, "of the surface"),
         number("wave_frequency", "1/s", 300.0, limits::finite,
                "at which the wave travels; times wave_height below regression_rate"),
         number("bottom_temperature", "K", 300.0, limits::positive, "T_0"),
         number("displacement", "m", 4e-6, limits::finite, "size of xi - (x, y)"),
         number("motion_frequency", "1/s", 800.0, limits::finite, "of the motion"),
         number("stress", "Pa", 200e6, limits::finite, "size of the stress"),
         number("pressure", "Pa", 2e6, limits::finite,
                "p_c, of which the traction is the remainder"),
         number("heat_flux", "W/m^2", 8e6, limits::finite,
                "Q_g, of which the heat flux is the remainder")});
}

}  // namespace

TruthEntry manufactured_burning_entry() {
    return {.name = "manufactured-burning",
            .description =
                "A whole burning solid, made up: surface, temperature, motion, stress "
                "and reference map, and the sources that the equations lack to have "
                "them for a solution. y in the laboratory.",
            .source =
                "manufactured for paper eq. 7, 9, 34 and 38 with beta = 3 alpha K; "
                "reference/manufactured_burning.hpp",
            .parameters = burning_parameters(),
            .fields = burning_fields(),
            .examples = lattice({0.0, 200e-6}, {-200e-6, -10e-6}),
            .example_time = 1e-3,
            .build = [](const Given& given) {
                const BurningParameters parameters = parameters_of(given);
                const ManufacturedBurning solid(parameters);
                return pointwise(
                    burning_fields(), around(solid, parameters.depth),
                    [solid](const Eigen::Vector2d& at, double t) { return row(solid, at, t); });
            }};
}

}  // namespace crawford::reference
