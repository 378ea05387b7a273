#include <algorithm>
#include <cmath>

#include "reference/slab.hpp"
#include "reference/slab_shooting.hpp"
#include "reference/slab_small_strain.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"
#include "reference/truth_of.hpp"

namespace crawford::reference {

namespace {

const std::vector<Eigen::Vector2d>& depths() {
    static const auto points = lattice({0.0, 120e-6}, {-300e-6, 0.0});
    return points;
}

/// Of a half space whose burn rate is given.
std::vector<Parameter> half_space_parameters(const std::vector<std::string>& properties) {
    return joined(
        material_parameters("AP", properties),
        {text("model", "eulerian", {"eulerian", "kuznetsov_stewart", "thermal", "mass_conserving"},
              "how stress and mass enter: finite strain carried by r_b + v at constant density; "
              "small strain; nothing expands; finite strain that conserves mass"),
         text("thermal_stress", "3 alpha K", {"3 alpha K", "alpha K"}, "beta"),
         text("heat_capacity", "c_p", {"c_p", "c_v"}, "which specific heat stands before DT/Dt"),
         number("heat_flux", "W/m^2", 200.0 * calorie_per_second_per_cm2, limits::positive,
                "Q, from the flame"),
         number("burn_rate", "m/s", 0.0045, limits::positive, "r_b, where it is fixed"),
         number("pressure", "Pa", 2e6, limits::finite, "p_c on the surface"),
         number("cold_temperature", "K", 300.0, limits::positive,
                "T0, far below or at the bottom")});
}

std::vector<Parameter> slab_parameters() {
    return joined(half_space_parameters(all_properties()),
                  {text("regression", "fixed", {"fixed", "pyrolysis"},
                        "burn_rate is given, or follows from the surface temperature"),
                   number("depth", "m", limits::infinity, limits::positive_or_infinite,
                          "of the layer; infinity for a half space")});
}

SlabModel model_of(const std::string& name) {
    if (name == "thermal") return SlabModel::thermal;
    if (name == "kuznetsov_stewart") return SlabModel::kuznetsov_stewart;
    if (name == "mass_conserving") return SlabModel::mass_conserving;
    return SlabModel::eulerian;
}

SlabConditions half_space(const Given& given) {
    return {.material = material_of(given),
            .model = model_of(given.text("model")),
            .thermal_stress = given.text("thermal_stress") == "alpha K"
                                  ? ThermalStress::alpha_k
                                  : ThermalStress::three_alpha_k,
            .heat_capacity = given.text("heat_capacity") == "c_v" ? HeatCapacity::constant_volume
                                                                  : HeatCapacity::constant_pressure,
            .heat_flux = given.number("heat_flux"),
            .burn_rate = given.number("burn_rate"),
            .pressure = given.number("pressure"),
            .cold_temperature = given.number("cold_temperature")};
}

SlabConditions conditions_of(const Given& given) {
    SlabConditions conditions = half_space(given);
    if (given.text("regression") == "pyrolysis") conditions.regression = Regression::pyrolysis;
    conditions.depth = given.number("depth");
    return conditions;
}

Domain below_surface(const SlabConditions& conditions) {
    return {.y = {-conditions.depth, 0.0}};
}

std::vector<double> heights(std::span<const Eigen::Vector2d> points) {
    std::vector<double> y;
    for (const Eigen::Vector2d& point : points) y.push_back(std::min(point.y(), 0.0));
    return y;
}

Fields global_fields() {
    return joined({scalar_field("surface_temperature", "K", "T_s, the same at every point"),
                   scalar_field("burn_rate", "m/s", "r_b, the same at every point")});
}

Fields slab_fields() {
    return joined({temperature_field(), scalar_field("temperature_gradient_y", "K/m", "dT/dy"),
                   vector_fields("velocity", "m/s", "of the solid above its cold speed"),
                   stress_fields(),
                   matrix_fields("deformation_gradient", "1",
                                 "relative to the incoming material; kuznetsov_stewart: to "
                                 "stress-free material"),
                   global_fields()});
}

Fields shot_fields() {
    return joined(
        {temperature_field(), vector_fields("velocity", "m/s", "of the solid above its cold speed"),
         scalar_field("stress_xx", "Pa", "Cauchy stress, tension positive"), global_fields()});
}

Truth as_truth(const SlabShooting& slab, const SlabConditions& conditions) {
    auto evaluate = [slab](std::span<const Eigen::Vector2d> points, double) {
        const std::vector<ShotState> states = slab.states(heights(points));
        Eigen::MatrixXd table(static_cast<Eigen::Index>(points.size()), 6);
        for (size_t k = 0; k < states.size(); ++k) {
            const ShotState& s = states[k];
            table.row(static_cast<Eigen::Index>(k)) << s.temperature, 0.0, s.velocity, s.stress_11,
                slab.surface_temperature(), slab.burn_rate();
        }
        return table;
    };
    return {shot_fields(), below_surface(conditions), evaluate};
}

Fields sensitivity_field() {
    return scalar_field("surface_temperature_per_theta", "K^2",
                        "d T_s/d(beta/P) at fixed beta^2/P, the same at every point");
}

}  // namespace

Truth truth_of(const Slab& slab) {
    auto evaluate = [slab](std::span<const Eigen::Vector2d> points, double) {
        const std::vector<SlabState> states = slab.states(heights(points));
        Eigen::MatrixXd table(static_cast<Eigen::Index>(points.size()), 15);
        for (size_t k = 0; k < states.size(); ++k) {
            const SlabState& s = states[k];
            table.row(static_cast<Eigen::Index>(k)) << s.temperature, s.temperature_gradient, 0.0,
                s.velocity, s.stress_11, s.stress_22, s.stress_33, 0.0, s.pressure, 1.0, 0.0, 0.0,
                s.deformation_gradient_22, slab.surface_temperature(), slab.burn_rate();
        }
        return table;
    };
    return {slab_fields(), below_surface(slab.conditions()), evaluate};
}

TruthEntry slab_entry() {
    return {.name = "slab",
            .description =
                "A homogeneous slab that burns steadily, seen from its surface, y = 0: "
                "temperature, velocity and stress in closed form.",
            .source =
                "paper eq. 7, 34, 38 in one dimension, and eq. 50-53 (Kuznetsov and Stewart); "
                "reference/slab.hpp",
            .parameters = slab_parameters(),
            .fields = slab_fields(),
            .examples = depths(),
            .build = [](const Given& given) { return truth_of(Slab(conditions_of(given))); }};
}

TruthEntry slab_shooting_entry() {
    return {.name = "slab-shooting",
            .description =
                "The slab once more by another road: its differential equations "
                "integrated from the cold side and shot at the surface's flux.",
            .source =
                "the equations of slab by the Bulirsch-Stoer method (Boost.Odeint); "
                "reference/slab_shooting.hpp",
            .parameters = slab_parameters(),
            .fields = shot_fields(),
            .examples = depths(),
            .build = [](const Given& given) {
                const SlabConditions conditions = conditions_of(given);
                return as_truth(SlabShooting(conditions), conditions);
            }};
}

TruthEntry slab_small_strain_entry() {
    return {.name = "slab-small-strain",
            .description =
                "How the surface temperature of the Eulerian slab leaves Kuznetsov and "
                "Stewart's as the strain grows from zero; a half space that burns at a "
                "prescribed rate.",
            .source =
                "perturbation of Kuznetsov and Stewart's solution (paper eq. 50-53); "
                "reference/slab_small_strain.hpp",
            .parameters = half_space_parameters({"thermal_conductivity", "specific_heat", "density",
                                                 "bulk_modulus", "shear_modulus",
                                                 "thermal_expansion", "heat_of_reaction"}),
            .fields = sensitivity_field(),
            .examples = depths(),
            .build = [](const Given& given) {
                const SlabConditions conditions = half_space(given);
                return pointwise(
                    sensitivity_field(), below_surface(conditions),
                    [sensitivity = small_strain_sensitivity(conditions)](
                        const Eigen::Vector2d&, double) { return Row().add(sensitivity); });
            }};
}

}  // namespace crawford::reference
